#include "mms/radial_profile.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <stdexcept>

namespace mpmvv::mms {

RadialProfile::RadialProfile(const Radii& radii) : radii_(radii) {
  const double R_I = radii.inner, R_O = radii.outer, singular = R_O - 3 * R_I;
  if (std::abs(singular) < 1e-9 * R_O)
    throw std::invalid_argument("W (61) is singular where the outer radius is three times the inner one");
  c3_ = -2 / (R_O * R_O * singular);
  c2_ = 3 * (R_O + R_I) / (R_O * R_O * singular);
  c1_ = -6 * R_I / (R_O * singular);
}

double RadialProfile::largest() const {  // |w| is largest at one of the radii, as w is monotonic between them
  return std::max(1.0, std::abs(radii_.inner * over_R(radii_.inner)));
}

double RadialProfile::steepest() const {
  const double middle = (radii_.inner + radii_.outer) / 2;
  const double stationary = std::clamp(-c2_ / (2 * c3_), radii_.inner, radii_.outer);  // of w/R, or the nearer radius
  return std::max({std::abs(slope(middle)), std::abs(over_R(radii_.inner)), std::abs(over_R(radii_.outer)),
                   std::abs(over_R(stationary))});
}

double RadialProfile::reference_radius(double T, double r) const {
  const auto excess = [&](double R) { return R + T * R * over_R(R) - r; };
  double lower = 0,
         upper = radii_.outer + r;  // enough where 1 + T w' >= 1 outside the body; else 1 + T w' falls to zero there
  if (c3_ * T < 0) {
    const double middle = (radii_.inner + radii_.outer) / 2, half = (radii_.outer - radii_.inner) / 2;
    const double reach = std::sqrt(half * half - 1 / (3 * c3_ * T));
    lower = std::max(lower, middle - reach);
    upper = std::min(upper, middle + reach);
  }
  if (excess(lower) > 0 || excess(upper) < 0)
    throw std::domain_error("no reference point found: the position is outside the body");
  using namespace boost::math::tools;
  std::uintmax_t most_iterations = 100;
  const auto [below, above] = toms748_solve(excess, lower, upper, eps_tolerance<double>(), most_iterations);
  return (below + above) / 2;
}

}  // namespace mpmvv::mms
