#include "studies/codes/displacement_checks.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/codes/output_fault.hpp"

namespace mpmvv::codes {

template <int D>
void require_same_displacements(const MatchedEnd<D>& end) {
  const Snapshot& s = end.snapshot;
  if (s.X.empty() || s.x.empty() || s.u.empty()) return;
  const double size = (end.particles.upper - end.particles.lower).norm();
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D> moved = end.particles.difference(end.x(line), vec<D>(s.X[line]));
    const double most = 1e-6 * std::max(size, end.x(line).norm()) + 10 * s.rounding_of_all;
    if (end.particles.difference(moved, end.u[line]).norm() <= most) continue;
    fail_output(
        "{} in {} has the displacement u = ({:.6g}) m, but x - X = ({:.6g}) m (the same: u counts from the undeformed "
        "position X, not from that at time zero; or leave u, or X and x, out)",
        name_of_particle(s, line), s.file, fmt::join(end.u[line], ", "), fmt::join(moved, ", "));
  }
}

template <int D>
void require_displacements_from_rest(const MatchedEnd<D>& end) {
  if (end.snapshot.u.empty()) return;
  double alone = 0, together = 0;
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D> error = end.error(line, end.particles.end_time);
    const Vec<D> start = end.particles.setup.solution->u(end.particles.X[end.particle[line]], 0);
    alone += error.squaredNorm();
    together += end.particles.difference(error, -start).squaredNorm();
  }
  const auto rms = [&end](double squares) { return std::sqrt(squares / static_cast<double>(end.size())); };
  const bool is_large = rms(alone) > 0.02 * end.particles.setup.solution->displacement_scale();
  if (!is_large || !(rms(together) < 0.1 * rms(alone))) return;
  fail_output(
      "displacements in {} count from the positions at time zero? They are {:.2g} m from the exact ones, and {:.2g} m "
      "together with those at time zero (u counts from the undeformed position X)",
      end.snapshot.file, rms(alone), rms(together));
}

template void require_same_displacements(const MatchedEnd<1>&);
template void require_same_displacements(const MatchedEnd<2>&);
template void require_same_displacements(const MatchedEnd<3>&);
template void require_displacements_from_rest(const MatchedEnd<1>&);
template void require_displacements_from_rest(const MatchedEnd<2>&);
template void require_displacements_from_rest(const MatchedEnd<3>&);

}  // namespace mpmvv::codes
