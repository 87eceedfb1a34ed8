#pragma once
#include "mms/catalogue.hpp"
#include "studies/problems/setup.hpp"

namespace mpmvv::problems {

using mms::density_parameter;
using mms::poissons_ratio_parameter;
using mms::youngs_modulus_parameter;

inline double unit_length(const Parameters&) {
  return 1;
}

/// Returns sqrt(E/ρ₀), the wave speed of the problems of S and W.
inline double bar_wave_speed(const Parameters& p) {
  return std::sqrt(p.at("youngs_modulus") / p.at("density"));
}

/// Returns sqrt((λ + 2μ)/ρ₀), the speed of the P wave.
inline double p_wave_speed(const Parameters& p) {
  const mms::Elasticity material = mms::elasticity(p);
  return std::sqrt((material.lambda() + 2 * material.mu()) / material.density);
}

/// Returns the solver's material for the elastic constants of the parameters. Its formulas are not those of the
/// solution, so that a mistake in those does not cancel.
template <class Material = solver::NeoHookeanLog>
Material material_of(const Parameters& p) {
  const auto nu = p.find("poissons_ratio");
  const double youngs_modulus = p.at("youngs_modulus"), poissons_ratio = nu == p.end() ? 0 : nu->second;
  return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio))};
}

/// Returns a problem with a periodic body of length 1 that moves for half a period, as in S.
template <int D>
Problem periodic_body(const char* name, const std::string& source, SetupFunction<D> setup) {
  return {.name = name,
          .source = source,
          .length_formula = "1",
          .length = unit_length,
          .parameters = mms::entry_named(name).parameters,
          .wave_speed_formula = "C = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1/C",
          .end_time = [](const Parameters& p) { return 1 / bar_wave_speed(p); },
          .boundary = "periodic",
          .setup = setup};
}

/// Returns a setup with the density, material and solution that belong to these parameters, and the default body.
template <int D>
Setup<D> setup_of(const char* solution, const Parameters& p) {
  return {.density = p.at("density"), .material = material_of(p), .solution = mms::make<D>(solution, p)};
}

}  // namespace mpmvv::problems
