#pragma once

namespace mpmvv::solver {

/// What a material with a history keeps on each particle, as of the last evaluation of its stress.
struct ThermalState {
  double J = 1;            ///< volume ratio
  double pressure = 0;     ///< Pa, without artificial viscosity
  double viscous = 0;      ///< Pa, artificial
  double energy = 0;       ///< internal, J/kg, from the reference state on
  double temperature = 0;  ///< K

  double total_pressure() const { return pressure + viscous; }
};

/// Over which time and length a stress with a history takes rates.
struct StressStep {
  double dt;  ///< s, since the last evaluation
  double h;   ///< m, the cell width
};

template <class Material>
inline constexpr bool has_history = requires(const Material& material) {
  material.state_at_rest();
};

}  // namespace mpmvv::solver
