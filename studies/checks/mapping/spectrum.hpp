#pragma once
#include <Eigen/Core>

namespace mpmvv::checks::mapping {

/// The largest modulus of an eigenvalue.
double spectral_radius(const Eigen::MatrixXd& map);

/// In ascending order.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& symmetric);

}  // namespace mpmvv::checks::mapping
