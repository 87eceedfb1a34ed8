#pragma once
#include "mms/elasticity.hpp"
#include "studies/problems/setup.hpp"

namespace mpmvv::problems {

// Parameters that several problems share, with the ranges in which they make sense.
inline Parameter amplitude_parameter(double value) {
  return {"amplitude", value, "m", [](double a) { return a > -1 && a < 1; }, "between -1 and 1"};
}
inline Parameter youngs_modulus_parameter(double value) {
  return {"youngs_modulus", value, "Pa", [](double e) { return e > 0; }, "> 0"};
}
inline Parameter poissons_ratio_parameter(double value) {
  return {"poissons_ratio", value, "", [](double nu) { return nu > -1 && nu < 0.5; }, "> -1 and < 0.5"};
}
inline Parameter density_parameter(double value) {
  return {"density", value, "kg/m3", [](double rho) { return rho > 0; }, "> 0"};
}

inline double unit_length(const Parameters&) {
  return 1;
}

/// sqrt(E/ρ₀), the wave speed of the S and W problems.
inline double bar_wave_speed(const Parameters& p) {
  return std::sqrt(p.at("youngs_modulus") / p.at("density"));
}

/// sqrt((λ + 2μ)/ρ₀), of the P wave.
inline double p_wave_speed(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  return std::sqrt((material.lambda() + 2 * material.mu()) / material.density);
}

/// The solver's material from the elastic constants of the parameters.
template <class Material = solver::NeoHookeanLog>
Material neo_hookean(double youngs_modulus, double poissons_ratio) {
  return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio))};
}

}  // namespace mpmvv::problems
