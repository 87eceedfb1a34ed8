#pragma once
#include <fmt/format.h>

#include "mms/radial_profile.hpp"
#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

// What the problems on rings and shells share.
inline Parameter inner_radius_parameter(double value) {
  return {"inner_radius", value, "m", [](double r) { return r > 0; }, "> 0"};
}
inline Parameter outer_radius_parameter(double value) {
  return {"outer_radius", value, "m", [](double r) { return r > 0; }, "> 0"};
}
inline mms::Radii radii(const Parameters& p) {
  return {p.at("inner_radius"), p.at("outer_radius")};
}
inline double outer_radius(const Parameters& p) {
  return p.at("outer_radius");
}
inline std::string radii_objection(const Parameters& p) {
  const double inner = p.at("inner_radius"), outer = p.at("outer_radius");
  return inner < outer ? "" : fmt::format("inner_radius {} is not below outer_radius {}", inner, outer);
}

/// Radial motion, W (60) to (62).
inline std::string radial_motion_objection(const Parameters& p) {
  if (const std::string objection = radii_objection(p); !objection.empty()) return objection;
  const mms::Radii r = radii(p);
  if (std::abs(r.outer - 3 * r.inner) < 1e-9 * r.outer)
    return fmt::format("outer_radius {} is three times inner_radius {}, where W (61) is singular (any other ratio)",
                       r.outer, r.inner);
  const double most = 1 / mms::RadialProfile(r).steepest();
  if (std::abs(p.at("amplitude")) < most) return "";
  return fmt::format("amplitude {} makes det F negative (below {:.4g} between these radii)", p.at("amplitude"), most);
}
inline Parameter radial_amplitude_parameter() {
  return {"amplitude", 0.1, "m", [](double) { return true; }, "small enough that det F stays positive"};
}
/// With a lateral contraction the surfaces, where F_RR = 1, carry the normal stress λ ln J.
inline bool has_poissons_ratio(const Parameters& p) {
  return p.at("poissons_ratio") != 0;
}

}  // namespace mpmvv::problems
