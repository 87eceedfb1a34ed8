#include "studies/runs/nodal_error.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace mpmvv::runs {

namespace {

/// Whether the node lies in the domain, is not the second image of one across periodic faces, and is accelerated.
template <int D>
bool counts(const solver::Mpm<D>& mpm, std::size_t n) {
  const auto i = mpm.grid().index(n);
  for (std::size_t d = 0; d < D; ++d) {
    const int end = mpm.periodic()[d] ? mpm.grid().cells()[d] : mpm.grid().inside(static_cast<int>(d));
    if (i[d] < 0 || i[d] >= end) return false;
  }
  return mpm.is_accelerated(n);
}

constexpr double round_off = 1e-12;  // in m, for nodes on a face

/// Moves X by whole periods into the grid that surrounds the body at rest: a body may drift through periodic faces.
template <int D>
mms::Vec<D> moved_home(mms::Vec<D> X, const solver::Mpm<D>& mpm, const problems::Body<D>& body) {
  const double h = mpm.grid().h();
  const auto lower = std::visit([h](const auto& shape) { return problems::domain(shape, h).lower; }, body);
  for (std::size_t d = 0; d < D; ++d) {
    if (!mpm.periodic()[d]) continue;
    const auto axis = static_cast<int>(d);
    const double period = h * mpm.grid().cells()[d];
    X[axis] -= period * std::floor((X[axis] - lower[axis] + round_off) / period);
  }
  return X;
}

/// Returns the reference position of the material point at x; none when no part of the body is there.
template <int D>
std::optional<mms::Vec<D>> reference_point(const solver::Mpm<D>& mpm, const mms::ManufacturedSolution<D>& solution,
                                           const problems::Body<D>& body, const mms::Vec<D>& x) {
  try {
    const mms::Vec<D> X = moved_home(solution.reference_point(x, mpm.time()), mpm, body);
    if (std::visit([&X](const auto& shape) { return problems::contains(shape, X, round_off); }, body)) return X;
    return std::nullopt;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

}  // namespace

template <int D>
ErrorNorms acceleration_errors(solver::Mpm<D>& mpm, const mms::ManufacturedSolution<D>& solution,
                               const problems::Body<D>& body) {
  mpm.map_acceleration();
  if (const std::string fault = mpm.fault(); !fault.empty()) throw std::runtime_error(fault);  // parts are not mapped
  ErrorNorms norms;
  for (std::size_t n = 0; n < mpm.grid().size(); ++n) {
    if (!counts(mpm, n)) continue;
    const auto X = reference_point(mpm, solution, body, mpm.node_position(n));
    if (!X) continue;
    norms.add((mpm.grid().a[n].template head<D>() - solution.a(*X, mpm.time())).norm());
  }
  return norms;
}

template ErrorNorms acceleration_errors(solver::Mpm<1>&, const mms::ManufacturedSolution<1>&, const problems::Body<1>&);
template ErrorNorms acceleration_errors(solver::Mpm<2>&, const mms::ManufacturedSolution<2>&, const problems::Body<2>&);
template ErrorNorms acceleration_errors(solver::Mpm<3>&, const mms::ManufacturedSolution<3>&, const problems::Body<3>&);

}  // namespace mpmvv::runs
