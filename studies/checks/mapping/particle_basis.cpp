#include "studies/checks/mapping/particle_basis.hpp"

#include <Eigen/QR>
#include <vector>

#include "studies/checks/mapping/matrix_product.hpp"

namespace mpmvv::checks::mapping {

namespace {

constexpr double least_mass = 1e-14;  ///< as a fraction of the largest nodal mass; less is round-off

std::vector<Eigen::Index> nodes_with_mass(const Eigen::VectorXd& masses) {
  std::vector<Eigen::Index> nodes;
  for (Eigen::Index i = 0; i < masses.size(); ++i)
    if (masses[i] > least_mass * masses.maxCoeff()) nodes.push_back(i);
  return nodes;
}

/// The mass matrix of the nodes with mass, factored. It is first scaled to ones on its diagonal, so that it does not
/// matter how small the mass of a node is.
struct ScaledMass {
  std::vector<Eigen::Index> nodes;
  Eigen::VectorXd scale;  ///< one over the square roots of the diagonal
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;

  explicit ScaledMass(const Eigen::MatrixXd& m)
      : nodes(nodes_with_mass(m.diagonal())), scale(m.diagonal()(nodes).cwiseSqrt().cwiseInverse()) {
    factors.setThreshold(1e-10);
    factors.compute(scale.asDiagonal() * m(nodes, nodes) * scale.asDiagonal());
  }
};

}  // namespace

ParticleBasis ParticleBasis::lumped(const Eigen::MatrixXd& v, const Eigen::VectorXd& M) {
  const Eigen::VectorXd m = v * M;
  Eigen::MatrixXd psi = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  for (const Eigen::Index i : nodes_with_mass(m)) psi.row(i) = v.row(i).cwiseProduct(M.transpose()) / m[i];
  return ParticleBasis(psi);
}

ParticleBasis ParticleBasis::consistent(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M) {
  const ScaledMass mass(m);
  const auto n = static_cast<Eigen::Index>(mass.nodes.size());
  const Eigen::MatrixXd unit =
      Eigen::MatrixXd::Identity(n, n);  // a matrix, so that `solve` compiles once; its solution is the pseudoinverse
  const Eigen::MatrixXd inverse = mass.scale.asDiagonal() * mass.factors.solve(unit) * mass.scale.asDiagonal();
  Eigen::MatrixXd psi = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  psi(mass.nodes, Eigen::all) = matrix_product(inverse, v(mass.nodes, Eigen::all)) * M.asDiagonal();
  return ParticleBasis(psi);
}

Eigen::MatrixXd nodal_values(const Eigen::MatrixXd& m, const Eigen::MatrixXd& v, const Eigen::VectorXd& M,
                             const Eigen::MatrixXd& f) {
  const ScaledMass mass(m);
  const Eigen::MatrixXd b = mass.scale.asDiagonal() * matrix_product(v, M.asDiagonal() * f)(mass.nodes, Eigen::all);
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(v.rows(), f.cols());
  F(mass.nodes, Eigen::all) = mass.scale.asDiagonal() * mass.factors.solve(b);
  return F;
}

}  // namespace mpmvv::checks::mapping
