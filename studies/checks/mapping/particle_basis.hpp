#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace mpmvv::checks::mapping {

/// The implied particle basis functions Φ_p(x) = Σ_i N_i(x) ψ_ip, B (16.30). Here v (nodes x particles) holds the v_ip,
/// M the masses (or volumes) of the particles, and m (nodes x nodes) is the consistent mass matrix. Nodes without mass
/// take no part: their ψ_ip is 0.
class ParticleBasis {
 public:
  /// Makes the basis of the lumped mass, ψ_ip = M_p v_ip / Σ_q M_q v_iq, B (16.31).
  static ParticleBasis lumped(const Eigen::MatrixXd& v, const Eigen::VectorXd& M);

  /// Makes the basis of a consistent mass, ψ_ip = Σ_j m⁻¹_ij M_p v_jp, B (16.30). Where m is singular, ψ is the
  /// solution of least norm.
  static ParticleBasis consistent(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M);

  const Eigen::MatrixXd& psi() const { return psi_; }  ///< nodes x particles
  bool reaches(Eigen::Index node) const { return psi_.row(node).cwiseAbs().maxCoeff() > 0; }

  /// Returns Φ_p at some points (particles x points) from the nodal functions N at them (nodes x points).
  Eigen::MatrixXd at(const Eigen::SparseMatrix<double>& N) const { return Eigen::MatrixXd(psi_.transpose()) * N; }

 private:
  explicit ParticleBasis(Eigen::MatrixXd psi) : psi_(std::move(psi)) {}

  Eigen::MatrixXd psi_;
};

/// Returns the nodal values F_i of Σ_j m_ij F_j = Σ_p f_p M_p v_ip, B (16.17), for each column of f. The system is
/// solved without an inverse. Nodes without mass have 0.
Eigen::MatrixXd nodal_values(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M,
                             const Eigen::MatrixXd& f);

}  // namespace mpmvv::checks::mapping
