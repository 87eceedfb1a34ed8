#include "studies/checks/mapping/particle_basis.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>
#include <vector>

namespace mpmvv::mapping {

namespace {

constexpr double least_mass = 1e-14;  ///< of the largest node's: below is round-off

std::vector<Eigen::Index> nodes_with_mass(const Eigen::VectorXd& masses) {
  std::vector<Eigen::Index> nodes;
  for (Eigen::Index i = 0; i < masses.size(); ++i)
    if (masses[i] > least_mass * masses.maxCoeff()) nodes.push_back(i);
  return nodes;
}

}  // namespace

ParticleBasis ParticleBasis::lumped(const Eigen::MatrixXd& v, const Eigen::VectorXd& M) {
  const Eigen::VectorXd m = v * M;
  Eigen::MatrixXd psi = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  for (const Eigen::Index i : nodes_with_mass(m)) psi.row(i) = v.row(i).cwiseProduct(M.transpose()) / m[i];
  return ParticleBasis(psi);
}

ParticleBasis ParticleBasis::consistent(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M) {
  const auto nodes = nodes_with_mass(m.diagonal());
  const Eigen::FullPivLU<Eigen::MatrixXd> inverse(m(nodes, nodes));
  if (!inverse.isInvertible()) throw std::runtime_error("mapping: the consistent mass matrix is singular");
  Eigen::MatrixXd psi = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  psi(nodes, Eigen::all) = inverse.inverse() * v(nodes, Eigen::all) * M.asDiagonal();
  return ParticleBasis(psi);
}

Eigen::VectorXd nodal_values(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M,
                             const Eigen::VectorXd& f) {
  const auto nodes = nodes_with_mass(m.diagonal());
  const Eigen::VectorXd b = v * M.cwiseProduct(f);
  Eigen::VectorXd F = Eigen::VectorXd::Zero(v.rows());
  F(nodes) = m(nodes, nodes).colPivHouseholderQr().solve(b(nodes));
  return F;
}

}  // namespace mpmvv::mapping
