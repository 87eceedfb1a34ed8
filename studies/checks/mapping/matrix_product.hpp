#pragma once
#include <Eigen/Core>

namespace mpmvv::checks::mapping {

/// a b. Expressions become matrices first: Eigen's product of each kind of them would compile for half a second.
Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace mpmvv::checks::mapping
