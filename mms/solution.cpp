#include "mms/solution.hpp"

#include <Eigen/LU>
#include <limits>
#include <stdexcept>
#include <utility>

namespace mpmvv::mms {

namespace {

/// Evaluates the formulas of a solution anew for each point and call.
template <int D>
class EvaluatedEachTime : public PointwiseSolution<D> {
 public:
  EvaluatedEachTime(const ManufacturedSolution<D>& solution, std::vector<Vec<D>> X)
      : solution_(solution), X_(std::move(X)) {}

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const override {
    for (const auto id : ids) *u++ = solution_.u(X_[id], t);
  }
  void body_force(double t, std::span<const std::uint32_t>, std::span<const Vec<D>> X, Vec<D>* b) const override {
    for (const Vec<D>& place : X) *b++ = solution_.b(place, t);
  }
  bool reads_places() const override { return true; }

 private:
  const ManufacturedSolution<D>& solution_;
  std::vector<Vec<D>> X_;
};

}  // namespace

template <int D>
std::unique_ptr<PointwiseSolution<D>> ManufacturedSolution<D>::at_points(const std::vector<Vec<D>>& X) const {
  return std::make_unique<EvaluatedEachTime<D>>(*this, X);
}

template <int D>
Vec<D> ManufacturedSolution<D>::reference_point(const Vec<D>& x, double t) const {
  constexpr int most_iterations = 50;
  constexpr double tolerance = 4 * std::numeric_limits<double>::epsilon();
  Vec<D> X = x;
  for (int k = 0; k < most_iterations; ++k) {
    const Vec<D> residual = X + u(X, t) - x;
    if (residual.norm() <= tolerance * (1 + x.norm())) return X;
    X -= F(X, t).inverse() * residual;
  }
  throw std::domain_error("no reference point found: the position is outside the body");
}

template class ManufacturedSolution<1>;
template class ManufacturedSolution<2>;
template class ManufacturedSolution<3>;

}  // namespace mpmvv::mms
