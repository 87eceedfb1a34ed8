#include "studies/checks/mapping/spectrum.hpp"

#include <Eigen/Eigenvalues>

namespace mpmvv::checks::mapping {

double spectral_radius(const Eigen::MatrixXd& map) {
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace mpmvv::checks::mapping
