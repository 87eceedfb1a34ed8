#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace mpmvv::checks::mapping {

/// The implied particle basis functions Φ_p(x) = Σ_i N_i(x) ψ_ip, B (16.30). Matrices: v is nodes x particles, v_ip;
/// M holds the particles' masses (or volumes); m is the consistent mass matrix, nodes x nodes. Nodes without mass take
/// no part: their ψ_ip is 0.
class ParticleBasis {
 public:
  /// ψ_ip = M_p v_ip / Σ_q M_q v_iq, B (16.31)
  static ParticleBasis lumped(const Eigen::MatrixXd& v, const Eigen::VectorXd& M);

  /// ψ_ip = Σ_j m⁻¹_ij M_p v_jp, B (16.30); where m is singular, the solution of least norm.
  static ParticleBasis consistent(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M);

  const Eigen::MatrixXd& psi() const { return psi_; }  ///< nodes x particles
  bool reaches(Eigen::Index node) const { return psi_.row(node).cwiseAbs().maxCoeff() > 0; }

  /// Φ_p, particles x points, from the nodal functions there, nodes x points.
  Eigen::MatrixXd at(const Eigen::SparseMatrix<double>& N) const { return Eigen::MatrixXd(psi_.transpose()) * N; }

 private:
  explicit ParticleBasis(Eigen::MatrixXd psi) : psi_(std::move(psi)) {}

  Eigen::MatrixXd psi_;
};

/// The nodal values F_i of Σ_j m_ij F_j = Σ_p f_p M_p v_ip, B (16.17), solved without an inverse, for each column of f;
/// 0 on nodes without mass.
Eigen::MatrixXd nodal_values(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M,
                             const Eigen::MatrixXd& f);

}  // namespace mpmvv::checks::mapping
