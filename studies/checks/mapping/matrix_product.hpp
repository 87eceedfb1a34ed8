#pragma once
#include <Eigen/Core>

namespace mpmvv::checks::mapping {

/// Returns a b. Expressions are turned into matrices first, because for each kind of expression Eigen's product would
/// take half a second to compile.
Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace mpmvv::checks::mapping
