#pragma once
#include "solver/map_surface_load.hpp"
#include "solver/mpm.hpp"
#include "solver/operations.hpp"
#include "solver/stages.hpp"
#include "solver/velocity_update/update_particle.hpp"

/// The phases of a step that visit particles.
namespace mpmvv::solver {

template <int D>
template <Adds adds, class... Stages>
void Mpm<D>::sweep(const Stages&... stages) {
  std::visit(
      [&](const auto& basis) { note(solver::sweep(adds, swept(basis), particles_, grid_, slabs_, team_, stages...)); },
      scene_.basis);
}

template <int D>
template <class... Ops>
void Mpm<D>::sweep_and_settle(const Ops&... ops) {
  sweep<Adds::nothing>(node_loop(ops...), CheckDeformation<D>{particles_}, UpdateWidth<D>{particles_},
                       SettlePosition<D>{particles_, periodic_, slabs_, must_sort_});
  ++moves_;
}

template <int D>
template <class Before, class... Map>
void Mpm<D>::sweep_with_forces(const Before& before, const Map&... map) {
  const EvaluateStress<D> stress{particles_, scene_.material, dt_};
  if (scene_.body_force && scene_.body_force_on == BodyForceOn::particles) {
    scene_.body_force->prepare(time_);
    sweep(before, stress, EvaluateBodyForce<D>{particles_, *scene_.body_force, time_},
          node_loop(map..., MapForces<D>{particles_, grid_}));
  } else {
    sweep(before, stress, node_loop(map..., MapInternalForce<D>{particles_, grid_}));
  }
  if (scene_.surface_load) add_surface_load();
  fold(grid_.f);
}

template <int D>
void Mpm<D>::add_surface_load() {
  scene_.surface_load->forces(time_, load_.data());
  std::visit(
      [this](const auto& basis) {
        note(map_surface_load(swept(basis), *scene_.surface_load, load_.data(), place_, particles_, grid_));
      },
      scene_.basis);
}

template <int D>
void Mpm<D>::map_acceleration() {
  clear_grid();
  sweep_with_forces(node_loop(), MapMass<D>{particles_, grid_});
  fold_momentum();
  set_grid_acceleration();
}

template <int D>
void Mpm<D>::set_stress_velocity() {
  set_grid_velocity();
  if (const auto* fmpm = std::get_if<Fmpm>(&scene_.velocity_update)) fmpm->sharpen(*this);
}

template <int D>
void Mpm<D>::update_stress_first(double dt_stress, double dt) {
  set_stress_velocity();
  sweep_with_forces(node_loop(UpdateDeformation<D>{particles_, grid_, deformation_step(dt_stress)}));
  if (expanded_inverse_) set_grid_velocity();
  set_grid_acceleration();
  advance_grid_velocity(dt);
}

template <int D>
VelocityFields<D> Mpm<D>::velocity_fields(double dt) {
  return std::visit([&](const auto& update) { return update.fields(*this, dt); }, scene_.velocity_update);
}

template <int D>
void Mpm<D>::update_particles(double dt, double dt_deformation) {
  const auto* flip = std::get_if<Flip>(&scene_.velocity_update);
  const UpdateVelocity<D> velocity{particles_, grid_, dt};
  const bool is_plain = flip && flip->position == FlipPosition::first_order;
  if (!is_plain && dt_deformation == 0)
    sweep_and_settle(UpdateVelocityAndPosition<D>{particles_, grid_, velocity_fields(dt), dt});
  else if (!is_plain)
    sweep_and_settle(UpdateParticle<D>{particles_, grid_, velocity_fields(dt), dt, deformation_step(dt_deformation)});
  else if (dt_deformation == 0)
    sweep_and_settle(velocity, UpdatePosition<D>{particles_, grid_, dt});
  else
    sweep_and_settle(velocity,
                     UpdatePositionAndDeformation<D>{particles_, grid_, dt, deformation_step(dt_deformation)});
}

}  // namespace mpmvv::solver
