#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "solver/material/thermal_state.hpp"
#include "solver/types.hpp"

namespace mpmvv::solver {

/// A solid under shock as a fluid without shear strength, N §3.5: the Mie-Grüneisen equation of state about a linear
/// Hugoniot U_s = c₀ + S₁ u_p with c₀² = K/ρ₀ and ργ = ρ₀γ₀, in the compression η = 1 - J,
///   p = K η (1 - γ₀η/2)/(1 - S₁η)² + γ₀ρ₀ e   (in tension K η + γ₀ρ₀ e),
/// and, while it is being compressed, Wilkins' artificial viscosity q = ρ Δx |D_kk| (A₁ c + A₂ Δx |D_kk|). Energy and
/// temperature follow adiabatically: ρ₀ de = -(p + q) dJ and C dT = -γ₀ C T dJ - q dJ/ρ₀. No heat is conducted: in the
/// microseconds of a shock it would spread over a few hundredths of a millimetre.
struct MieGruneisen {
  static constexpr std::string_view word = "mie-gruneisen";

  double density = 1;         ///< ρ₀, kg/m³
  double bulk_modulus = 0;    ///< K, Pa
  double hugoniot_slope = 0;  ///< S₁
  double gamma = 0;           ///< γ₀
  double heat_capacity = 1;   ///< C at constant volume, J/(kg K)
  double temperature = 0;     ///< at rest, K
  double A1 = 0, A2 = 0;      ///< A₁ and A₂, linear and quadratic coefficients of the artificial viscosity

  ThermalState state_at_rest() const { return {.temperature = temperature}; }

  /// Returns the state at the volume ratio J on the isentrope through the state at rest: a body that starts deformed
  /// was deformed slowly, and q = 0.
  ThermalState state_at(double J) const {
    constexpr int steps = 100;  // at J = 0.75 the energy of nickel is then 4e-5 of itself too large
    MieGruneisen slow = *this;
    slow.A1 = slow.A2 = 0;
    ThermalState state = state_at_rest();
    for (int k = 1; k <= steps && J != 1; ++k) slow.advance(state, k < steps ? 1 + (J - 1) * k / steps : J, {1, 1});
    return state;
  }

  /// Returns p at e = 0, Pa. From the Hugoniot's pole η = 1/S₁ on it is infinite, which ends a run.
  double cold_pressure(double eta) const {
    if (eta <= 0) return bulk_modulus * eta;
    const double room = 1 - hugoniot_slope * eta;
    if (room <= 0) return std::numeric_limits<double>::infinity();
    return bulk_modulus * eta * (1 - 0.5 * gamma * eta) / (room * room);
  }
  double cold_slope(double eta) const {
    if (eta <= 0) return bulk_modulus;
    const double room = 1 - hugoniot_slope * eta;
    return bulk_modulus * ((1 - gamma * eta) * room + 2 * hugoniot_slope * eta * (1 - 0.5 * gamma * eta)) /
           (room * room * room);
  }

  /// Returns c in m/s, from c² = (∂p/∂ρ) at constant entropy = J²/ρ₀ (dp/dη + γ₀ p). It is zero where c² would be
  /// negative.
  double wave_speed(const ThermalState& s) const {
    return s.J * std::sqrt(std::max(0.0, (cold_slope(1 - s.J) + gamma * s.pressure) / density));
  }

  /// Returns q in Pa, if the volume ratio has fallen by `fall` since the last evaluation; zero if it has not fallen.
  double viscous_pressure(const ThermalState& s, double fall, const StressStep& step) const {
    if (!(fall > 0)) return 0;
    const double J = s.J - 0.5 * fall, width_rate = step.h * fall / (J * step.dt);  // Δx |D_kk|
    return density / J * width_rate * (A1 * wave_speed(s) + A2 * width_rate);
  }

  /// Advances the state to the volume ratio J by the trapezoidal rule in p.
  void advance(ThermalState& s, double J, const StressStep& step) const {
    const double fall = s.J - J, q = viscous_pressure(s, fall, step);
    const double cold = cold_pressure(1 - J), heating = gamma * density;
    const double pressure =
        (cold + heating * s.energy + gamma * fall * (0.5 * s.pressure + q)) / (1 - 0.5 * gamma * fall);
    s.energy += fall / density * (0.5 * (s.pressure + pressure) + q);
    s.temperature *= (1 + 0.5 * gamma * fall) / (1 - 0.5 * gamma * fall);
    s.temperature += q * fall / (density * heat_capacity);
    s.pressure = pressure;
    s.viscous = q;
    s.J = J;
  }

  /// Returns the Kirchhoff stress τ = -J (p + q) I, and advances the state to J = det F first.
  template <int D>
  Mat<D> kirchhoff(const Mat<D>& F, ThermalState& state, const StressStep& step) const {
    const double J = F.determinant();
    advance(state, J, step);
    return -J * state.total_pressure() * Mat<D>::Identity();
  }
};

}  // namespace mpmvv::solver
