#pragma once
#include "solver/consistent_mass.hpp"
#include "solver/mpm.hpp"
#include "solver/velocity_update/expanded_inverse.hpp"

/// The phases of a step that visit nodes.
namespace mpmvv::solver {

template <int D>
template <class Visit>
void Mpm<D>::for_faces(const Visit& visit) {
  for (int d = 0; d < D; ++d)
    for (const bool upper : {false, true})
      std::visit(
          [&](const auto& boundary) {
            visit(boundary, Face{d, upper});
          },
          scene_.boundary[static_cast<std::size_t>(2 * d + (upper ? 1 : 0))]);
}

template <int D>
template <class V>
void Mpm<D>::clear(std::vector<V>& field) {
  for_pieces(team_, field.size(),
             [&field](std::size_t begin, std::size_t end) { std::fill(&field[begin], &field[0] + end, V::Zero()); });
}

template <int D>
void Mpm<D>::clear_grid() {
  clear(grid_.p);
  clear(grid_.f);
}

template <int D>
template <class V>
void Mpm<D>::fold(std::vector<V>& field) {
  for_faces([&](const auto& boundary, Face face) { boundary.fold(grid_, face, field); });
}

template <int D>
void Mpm<D>::fold_momentum() {
  fold(grid_.p);
  for_nodes([this](std::size_t n) {
    if (grid_.m(n) > 0) return;
    grid_.v[n].setZero();
    grid_.a[n].setZero();
  });
  active_nodes_.find(team_, [this](std::size_t n) { return grid_.m(n) > 0; });
}

template <int D>
void Mpm<D>::constrain(std::vector<Packed<D>>& field) {
  for_faces([&](const auto& boundary, Face face) { boundary.constrain(grid_, face, field); });
  for (const auto& wall : walls_) wall.clear(grid_, field);
}

template <int D>
void Mpm<D>::hold(std::vector<Packed<D>>& velocity) {
  constrain(velocity);
  for (const auto& wall : walls_) wall.hold(grid_, velocity);
}

template <int D>
void Mpm<D>::constrain_transposed(std::vector<Packed<D>>& field) {
  for_faces([&]<class Boundary>(const Boundary& boundary, Face face) {
    if constexpr (Boundary::holds) boundary.constrain_transposed(grid_, face, field);
  });
  for (const auto& wall : walls_) wall.clear(grid_, field);
}

template <int D>
template <class V>
void Mpm<D>::divide_by_mass(const std::vector<V>& field, double least_mass, std::vector<Packed<D>>& quotient) {
  for_nodes([&](std::size_t n) {
    const double share = grid_.m(n) > least_mass ? 1 / grid_.m(n) : 0.0;
    quotient[n] = share * field[n].template head<lanes<D>>();
  });
}

template <int D>
void Mpm<D>::set_grid_velocity() {
  divide_by_mass(grid_.p, 0, grid_.v);
  for (auto& wall : walls_) wall.meet(grid_);
  if (holds_lumped()) hold(grid_.v);
  if (consistent_mass_) consistent_mass_->solve(*this, grid_.p, 0, grid_.v);
}

template <int D>
void Mpm<D>::set_grid_acceleration() {
  if (scene_.body_force && scene_.body_force_on == BodyForceOn::grid) add_grid_body_force();
  divide_by_mass(grid_.f, least_mass_, grid_.a);
  if (!scene_.difference_acceleration && holds_lumped()) constrain(grid_.a);
  if (consistent_mass_) consistent_mass_->solve(*this, grid_.f, least_mass_, grid_.a);
  if (scene_.half_start && steps_ == 0)
    for (auto& a : grid_.a) a *= 0.5;
}

template <int D>
void Mpm<D>::add_grid_body_force() {
  for_nodes([&](std::size_t n) {
    if (is_accelerated(n))
      grid_.f[n] += grid_.m(n) * packed<D>(scene_.body_force->at_position(node_position(n), time_));
  });
}

template <int D>
void Mpm<D>::advance_grid_velocity(double dt) {
  for_nodes([&](std::size_t n) { grid_.v[n] += dt * grid_.a[n]; });
  if (!holds_lumped()) return;
  hold(grid_.v);
  if (scene_.difference_acceleration) set_wall_acceleration(dt);
  for (const auto& wall : walls_) wall.set_acceleration(grid_, dt);
}

template <int D>
bool Mpm<D>::holds_lumped() const {
  const auto* fmpm = std::get_if<Fmpm>(&scene_.velocity_update);
  return !expanded_inverse_ || !fmpm || !fmpm->is_due(*this) || scene_.wall_method != WallMethod::velocity;
}

template <int D>
void Mpm<D>::expand_inverse(int order, std::vector<Packed<D>>& velocity) {
  if (expanded_inverse_)
    expanded_inverse_->apply(*this, order, scene_.wall_method == WallMethod::elimination, velocity);
}

template <int D>
void Mpm<D>::hold_expanded(std::vector<Packed<D>>& velocity) {
  if (expanded_inverse_ && scene_.wall_method != WallMethod::lumped) hold(velocity);
}

template <int D>
void Mpm<D>::set_wall_acceleration(double dt) {
  const auto difference = [&](int n, int) {  // a_i = (v_i^{k+1} - v_i^k)/Δt, v^k as mapped                     S (30)
    const auto i = static_cast<std::size_t>(n);
    if (is_accelerated(i)) grid_.a[i] = (grid_.v[i] - grid_.p[i].template head<lanes<D>>() / grid_.m(i)) / dt;
  };
  for_faces([&](const auto& boundary, Face face) {
    if (!boundary.holds) return;
    const FaceNodes<D> nodes{grid_, face};
    for (int layer = 0; layer <= nodes.layers(); ++layer)
      grid_.for_plane(face.axis, nodes.ghost(layer), nodes.ghost(layer), difference);
  });
}

}  // namespace mpmvv::solver
