#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "mms/elasticity.hpp"
#include "mms/radii.hpp"

namespace mpmvv::mms {

using Values = std::map<std::string, double>;  ///< values of parameters, by name

/// A physical value that a solution depends on.
struct Parameter {
  std::string name;
  double value;  ///< the default
  std::string unit;
  std::function<bool(double)> allowed;
  std::string range;  ///< `allowed` in words, for people: "> 0"
};

// Parameters that several solutions share, with the ranges in which they make sense.
inline Parameter youngs_modulus_parameter(double value) {
  return {"youngs_modulus", value, "Pa", [](double e) { return e > 0; }, "> 0"};
}
inline Parameter poissons_ratio_parameter(double value) {
  return {"poissons_ratio", value, "", [](double nu) { return nu > -1 && nu < 0.5; }, "> -1 and < 0.5"};
}
inline Parameter density_parameter(double value) {
  return {"density", value, "kg/m3", [](double rho) { return rho > 0; }, "> 0"};
}
/// Returns the parameter for the amplitude A of a motion along the axes with k half waves (1 or 2) in a unit length: k
/// π |A| < 1.
inline Parameter amplitude_parameter(double value, int k) {
  return {"amplitude", value, "m", [k](double a) { return k * std::numbers::pi * std::abs(a) < 1; },
          k == 1 ? "between -1/pi and 1/pi, where det F stays positive"
                 : "between -1/(2 pi) and 1/(2 pi), where det F stays positive"};
}

inline Elasticity elasticity(const Values& values) {
  const auto nu = values.find("poissons_ratio");
  return {values.at("youngs_modulus"), nu == values.end() ? 0 : nu->second, values.at("density")};
}
inline Radii radii(const Values& values) {
  return {values.at("inner_radius"), values.at("outer_radius")};
}

}  // namespace mpmvv::mms
