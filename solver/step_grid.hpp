#pragma once
#include "solver/consistent_mass.hpp"
#include "solver/step.hpp"
#include "solver/velocity_update/expanded_inverse.hpp"

/// The phases of a step that visit nodes.
namespace mpmvv::solver {

template <int D>
void Step<D>::clear_grid() {
  clear_momentum();
  clear(grid_.f);
}

/// Clears p where particles have been mapped to: on the nodes with mass, or everywhere if these have not been found
/// since.
template <int D>
void Step<D>::clear_momentum() {
  if (has_mapped_)
    clear(grid_.p);
  else
    for_nodes([p = grid_.p.data()](std::size_t n) { p[n].setZero(); });
  has_mapped_ = true;
}

template <int D>
void Step<D>::sum_momentum_images() {
  sum_over_faces(grid_.p);
  if (needs_whole_orbits()) {
    orbits_.sum(grid_.p);
    find_active_nodes();
  } else {
    if (find_active_nodes())
      orbits_.take_those_with_mass(grid_, [this](std::size_t n) { return active_nodes_.contain(n); });
    orbits_.sum(grid_.p);
  }
}

/// Finds the nodes that have mass now, and returns whether they are others than before.
template <int D>
bool Step<D>::find_active_nodes() {
  has_mapped_ = false;
  return active_nodes_.find(
      pool_, [mass_and_momentum = grid_.p.data()](std::size_t n) { return mass_and_momentum[n][D] > 0; },
      [this](std::size_t n) {
        grid_.v[n].setZero();
        grid_.a[n].setZero();
      });
}

/// Whether a step needs nodes that only images give mass, not particles: for walls, which estimate gradients along
/// lines of nodes, planes of symmetry, which copy from nodes inside to ghosts, and the consistent mass, whose products
/// of fields take all nodes. Otherwise these nodes are left out, as particles gather nothing from them.
template <int D>
bool Step<D>::needs_whole_orbits() const {
  const auto is_symmetry = [](const AnyBoundary& face) { return std::holds_alternative<Symmetry>(face); };
  return scene_.consistent_mass || !walls_.empty() || std::ranges::any_of(scene_.boundary, is_symmetry);
}

template <int D>
void Step<D>::constrain(Field& field) {
  for_faces([&](const auto& boundary, Face face) { boundary.constrain(grid_, face, field); });
  for (const auto& wall : walls_) wall.clear(grid_, field);
}

/// Makes velocities obey the faces and the moving walls.
template <int D>
void Step<D>::hold(Field& velocity) {
  constrain(velocity);
  for (const auto& wall : walls_) wall.hold(grid_, velocity);
}

template <int D>
void Step<D>::constrain_transposed(Field& field) {
  for_faces([&]<class Boundary>(const Boundary& boundary, Face face) {
    if constexpr (Boundary::holds) boundary.constrain_transposed(grid_, face, field);
  });
  for (const auto& wall : walls_) wall.clear(grid_, field);
}

/// Sets quotient = field / m_i on nodes whose mass exceeds `least_mass`, and zero on the other nodes with mass.
template <int D>
void Step<D>::divide_by_mass(const auto& field, double least_mass, Field& quotient) {
  for_nodes([&](std::size_t n) {
    const double share = grid_.m(n) > least_mass ? 1 / grid_.m(n) : 0.0;
    quotient[n] = share * field[n].template head<padded_size<D>>();
  });
}

template <int D>
void Step<D>::set_velocity() {
  has_expanded_velocity_ = false;
  divide_by_mass(grid_.p, 0, grid_.v);
  for (auto& wall : walls_) wall.meet(grid_);
  if (holds_before_expansion()) hold(grid_.v);
  if (consistent_mass_) consistent_mass_->solve(*this, grid_.p, 0, grid_.v);
}

template <int D>
void Step<D>::set_acceleration() {
  if (scene_.body_force && scene_.body_force_on == BodyForceOn::grid) add_grid_body_force();
  divide_by_mass(grid_.f, least_mass_, grid_.a);
  if (!scene_.difference_acceleration && holds_before_expansion()) constrain(grid_.a);
  if (consistent_mass_) consistent_mass_->solve(*this, grid_.f, least_mass_, grid_.a);
  if (scene_.half_start && steps_ == 0)  // W §4
    for (auto& a : grid_.a) a *= 0.5;
}

template <int D>
void Step<D>::add_grid_body_force() {
  for_nodes([&](std::size_t n) {
    if (is_accelerated(n))
      grid_.f[n] += grid_.m(n) * padded<D>(scene_.body_force->at_position(node_position(n), time_));
  });
}

template <int D>
void Step<D>::advance_velocity(double dt) {
  for (auto& wall : walls_) wall.pass_to_end();
  for_nodes([&](std::size_t n) { grid_.v[n] += dt * grid_.a[n]; });
  if (!holds_before_expansion()) return;
  hold(grid_.v);
  if (scene_.difference_acceleration) set_difference_acceleration(dt);
  for (const auto& wall : walls_) wall.set_acceleration(grid_, dt);
}

/// Whether faces and walls hold lumped velocities and accelerations: always, except on a step that expands the grid
/// velocity with the wall method `velocity`.
template <int D>
bool Step<D>::holds_before_expansion() const {
  return !expanded_inverse_ || !expands_grid_velocity(scene_.velocity_update, steps_) ||
         scene_.wall_method != WallMethod::velocity;
}

template <int D>
void Step<D>::expand_inverse(Field& velocity) {
  if (expanded_inverse_) expanded_inverse_->apply(*this, scene_.wall_method == WallMethod::elimination, velocity);
}

template <int D>
void Step<D>::hold_after_expansion(Field& velocity) {
  if (expanded_inverse_ && scene_.wall_method != WallMethod::lumped) hold(velocity);
}

template <int D>
void Step<D>::expand_velocity() {
  if (!expanded_inverse_ || !expands_grid_velocity(scene_.velocity_update, steps_)) return;
  expand_inverse(grid_.v);
  hold_after_expansion(grid_.v);
  has_expanded_velocity_ = true;
}

template <int D>
void Step<D>::set_stress_velocity() {
  for (auto& wall : walls_) wall.hold_as_mapped();
  set_velocity();
  expand_velocity();
  for (auto& wall : walls_) wall.hold_as_advanced();
}

/// Makes v_i = p_i / m_i again where F followed another v_i. There are two cases. With `fmpm` v was expanded for F.
/// With the consistent mass and a wall that accelerates, v of free nodes depends on the velocity that the wall holds: F
/// followed a v solved for with that of t^n, but v⁺ = v + Δt a needs one solved for with that of t^n + Δt, because a is
/// solved for with zero on held nodes. With the lumped mass v of free nodes does not depend on held ones.
template <int D>
void Step<D>::restore_velocity() {
  const bool is_solved_anew =
      consistent_mass_ && std::ranges::any_of(walls_, [](const auto& wall) { return wall.accelerates(); });
  if (has_expanded_velocity_ || is_solved_anew) set_velocity();
}

template <int D>
VelocityFields<D> Step<D>::velocity_fields(double dt) {
  return std::visit([&](const auto& update) { return update.prepare(*this, dt); }, scene_.velocity_update);
}

/// Sets the acceleration of nodes that boundaries hold. Moving walls set theirs in any case, by `MovingWall`.
template <int D>
void Step<D>::set_difference_acceleration(double dt) {
  const auto difference = [&](int n) {  // a_i = (v_i^{k+1} - v_i^k)/Δt, v^k as mapped                     S (30)
    const auto i = static_cast<std::size_t>(n);
    if (is_accelerated(i)) grid_.a[i] = (grid_.v[i] - grid_.p[i].template head<padded_size<D>>() / grid_.m(i)) / dt;
  };
  for_faces([&](const auto& boundary, Face face) {
    if (!boundary.holds) return;
    const FaceNodes<D> nodes{grid_, face};
    for (int layer = 0; layer <= nodes.layers(); ++layer) grid_.for_plane(face.axis, nodes.at(layer), difference);
  });
}

}  // namespace mpmvv::solver
