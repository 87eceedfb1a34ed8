#pragma once
#include <Eigen/Core>

namespace mpmvv::checks::mapping {

/// Returns the largest modulus of an eigenvalue.
double spectral_radius(const Eigen::MatrixXd& map);

/// Returns the eigenvalues of a symmetric matrix in ascending order.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& symmetric);

}  // namespace mpmvv::checks::mapping
