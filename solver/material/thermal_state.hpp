#pragma once

namespace mpmvv::solver {

/// The state that each particle of a material with a history keeps, as of the last evaluation of its stress.
struct ThermalState {
  double J = 1;            ///< volume ratio
  double pressure = 0;     ///< p, without artificial viscosity, Pa
  double viscous = 0;      ///< q, the artificial viscosity, Pa
  double energy = 0;       ///< internal energy since the reference state, J/kg
  double temperature = 0;  ///< K

  double total_pressure() const { return pressure + viscous; }
};

/// The time and the length by which the stress of a material with a history computes rates.
struct StressStep {
  double dt;  ///< the time step, taken as the time since the last evaluation, s
  double h;   ///< the cell width, m
};

/// A material with a history has `state_at_rest`, `state_at` (a volume ratio at which a body starts), and a `kirchhoff`
/// that advances a state.
template <class Material>
inline constexpr bool has_history = requires(const Material& material) {
  material.state_at_rest();
};

}  // namespace mpmvv::solver
