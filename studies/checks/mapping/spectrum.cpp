#include "studies/checks/mapping/spectrum.hpp"

#include <Eigen/Eigenvalues>

#include "studies/checks/extremes.hpp"

namespace mpmvv::checks::mapping {

double spectral_radius(const Eigen::MatrixXd& map) {
  return largest_of(map.eigenvalues().cwiseAbs());
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace mpmvv::checks::mapping
