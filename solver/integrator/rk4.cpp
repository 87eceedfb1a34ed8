#include <array>
#include <optional>

#include "solver/integrator/integrators.hpp"
#include "solver/kernels/advance_stage.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// The classical Runge-Kutta method of fourth order, for MPM as a system of ordinary differential equations. The state
/// is y = (x_p, v_p, F_p), with l_p = l_p⁰ diag F_p for a basis whose width follows F. Its rates g at time t are those
/// that particles find on the grid by the weights at x_p,
///   m_i = Σ_p N_ip m_p,   v_i = Σ_p N_ip m_p v_p / m_i,   a_i = f_i(x, F, t) / m_i,   both constrained,
///   x_p' = Σ_i N_ip v_i,  v_p' = Σ_i N_ip a_i,            F_p' = (Σ_i v_i ⊗ ∇N_ip) F_p,
/// which is what every integrator here tends to as Δt -> 0: S (1) to (10) divided by Δt. Then
///   k_1 = g(t, y), k_2 = g(t + Δt/2, y + Δt/2 k_1), k_3 = g(t + Δt/2, y + Δt/2 k_2), k_4 = g(t + Δt, y + Δt k_3),
///   y += Δt (k_1 + 2 k_2 + 2 k_3 + k_4)/6.
/// The rates are only as smooth as ∇N: the order is four as long as no particle crosses a knot of the basis. On a fixed
/// grid all other integrators with `flip` converge to this limit with first order, also cd. They keep the weights of
/// t^n through the step; and x, except in uvf, follows v_i + Δt a_i, although the new particle velocities map to
/// v_i + Δt (S⁺S a)_i. In cd these terms are of order h² Δt, so that it is of second order when the time step is
/// refined with the grid.
template <int D>
void rk4(Step<D>& s, double dt) {
  struct Stage {
    double time, weight;
    std::optional<double> next;
  };
  const std::array<Stage, 4> stages{
      {{0, dt / 6, dt / 2}, {dt / 2, dt / 3, dt / 2}, {dt / 2, dt / 3, dt}, {dt, dt / 6, {}}}};

  const double t = s.time();
  s.particles().start_stages();
  for (const Stage& stage : stages) {
    s.set_time(t + stage.time);
    s.map_momentum_and_forces();  // m_i, p_i; τ_p = τ(F_p), f_i
    s.set_velocity();             // v_i
    s.set_acceleration();         // a_i
    s.last_sweep(AdvanceStage<D>{s.particles(), s.grid(), stage.weight, stage.next},
                 CheckDeformation<D>{s.particles()});
  }
}

}  // namespace

Integrator rk4_integrator() {
  return {.word = "rk4", .in_1d = &rk4<1>, .in_2d = &rk4<2>, .in_3d = &rk4<3>, .is_staged = true};
}

}  // namespace mpmvv::solver
