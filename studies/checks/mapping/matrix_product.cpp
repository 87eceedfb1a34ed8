#include "studies/checks/mapping/matrix_product.hpp"

namespace mpmvv::checks::mapping {

Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a * b;
}

}  // namespace mpmvv::checks::mapping
