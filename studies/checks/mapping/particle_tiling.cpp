#include "studies/checks/mapping/particle_tiling.hpp"

#include <algorithm>
#include <numeric>

#include "studies/checks/basis_function.hpp"

namespace mpmvv::checks::mapping {

namespace {

constexpr double slack = 1e-9;  ///< tolerance for points and boxes on faces, and for boxes of one size

std::vector<double> equal_parts(double whole, int count) {
  return std::vector<double>(static_cast<std::size_t>(count), whole / count);
}

std::vector<double> random_parts(double whole, int count, Random& random) {
  std::vector<double> parts;
  for (int k = 0; k < count; ++k) parts.push_back(random.uniform(0.5, 1.5));
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  for (double& part : parts) part *= whole / sum;
  return parts;
}

/// Returns boxes whose sizes along an axis are `parts(whole, count)`. In two dimensions they lie in rows, one above the
/// other, and each row is divided anew.
template <int D, class Parts>
ParticleTiling<D> tiling_of_parts(const solver::Vec<D>& lower, const solver::Vec<D>& extent,
                                  const solver::Index<D>& count, const Parts& parts) {
  if constexpr (D == 1) {
    return tiling_of_widths(lower[0], parts(extent[0], count[0]));
  } else {
    ParticleTiling<D> tiling;
    double bottom = lower[1];
    for (const double height : parts(extent[1], count[1])) {
      const ParticleTiling<1> row = tiling_of_widths(lower[0], parts(extent[0], count[0]));
      for (std::size_t p = 0; p < row.x.size(); ++p) {
        tiling.x.emplace_back(row.x[p][0], bottom + height / 2);
        tiling.width.emplace_back(row.width[p][0], height);
      }
      bottom += height;
    }
    tiling.lower = lower, tiling.upper = lower + extent;
    return tiling;
  }
}

}  // namespace

template <int D>
Eigen::VectorXd ParticleTiling<D>::volumes() const {
  Eigen::VectorXd V(size());
  for (std::size_t p = 0; p < x.size(); ++p) V[static_cast<Eigen::Index>(p)] = width[p].prod();
  return V;
}

template <int D>
Eigen::VectorXd ParticleTiling<D>::masses() const {
  Eigen::VectorXd M = volumes();
  for (std::size_t p = 0; p < x.size(); ++p) M[static_cast<Eigen::Index>(p)] *= density(x[p]);
  return M;
}

template <int D>
bool ParticleTiling<D>::boxes_are_alike() const {
  return std::all_of(width.begin(), width.end(), [this](const Vec& w) { return w.isApprox(width[0], slack); });
}

template <int D>
bool ParticleTiling<D>::contains(const Vec& at, const Vec& depth) const {
  return ((at - lower - depth).array() > -slack).all() && ((upper - depth - at).array() > -slack).all();
}

template <int D>
bool ParticleTiling<D>::box_is_inside(std::size_t p, const Vec& depth) const {
  return contains(x[p], depth + width[p] / 2);
}

template <int D>
ParticleTiling<D> ParticleTiling<D>::translated(const Vec& u) const {
  ParticleTiling moved = *this;
  for (Vec& at : moved.x) at += u;
  moved.lower += u, moved.upper += u;
  return moved;
}

template <int D>
ParticleTiling<D> ParticleTiling<D>::stretched(const Vec& factor, const Vec& about) const {
  ParticleTiling moved = *this;
  const auto place = [&](const Vec& at) { return Vec(about + factor.cwiseProduct(at - about)); };
  for (std::size_t p = 0; p < x.size(); ++p) moved.x[p] = place(x[p]), moved.width[p] = factor.cwiseProduct(width[p]);
  moved.lower = place(lower), moved.upper = place(upper);
  moved.density_at_lower /= factor.prod();
  moved.density_gradient = density_gradient.cwiseQuotient(factor) / factor.prod();
  return moved;
}

template <int D>
ParticleTiling<D> uniform_tiling(const solver::Vec<D>& lower, const solver::Vec<D>& extent,
                                 const solver::Index<D>& count) {
  return tiling_of_parts<D>(lower, extent, count, &equal_parts);
}

template <int D>
ParticleTiling<D> random_tiling(const solver::Vec<D>& lower, const solver::Vec<D>& extent,
                                const solver::Index<D>& count, std::uint64_t seed) {
  Random random(seed);
  auto tiling = tiling_of_parts<D>(lower, extent, count,
                                   [&random](double whole, int n) { return random_parts(whole, n, random); });
  tiling.density_gradient = 2 * extent.cwiseInverse();
  return tiling;
}

ParticleTiling<1> tiling_of_widths(double lower, const std::vector<double>& widths) {
  ParticleTiling<1> tiling;
  tiling.lower = tiling.upper = solver::Vec<1>(lower);
  for (const double width : widths) {
    tiling.x.emplace_back(tiling.upper + solver::Vec<1>(width / 2));
    tiling.width.emplace_back(width);
    tiling.upper += solver::Vec<1>(width);
  }
  return tiling;
}

template struct ParticleTiling<1>;
template struct ParticleTiling<2>;
template ParticleTiling<1> uniform_tiling<1>(const solver::Vec<1>&, const solver::Vec<1>&, const solver::Index<1>&);
template ParticleTiling<2> uniform_tiling<2>(const solver::Vec<2>&, const solver::Vec<2>&, const solver::Index<2>&);
template ParticleTiling<1> random_tiling<1>(const solver::Vec<1>&, const solver::Vec<1>&, const solver::Index<1>&,
                                            std::uint64_t);
template ParticleTiling<2> random_tiling<2>(const solver::Vec<2>&, const solver::Vec<2>&, const solver::Index<2>&,
                                            std::uint64_t);

}  // namespace mpmvv::checks::mapping
