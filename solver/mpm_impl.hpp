#pragma once
#include <numeric>
#include <stdexcept>

#include "solver/integrator/integrators.hpp"
#include "solver/mpm.hpp"
#include "solver/velocity_update/update_particle.hpp"

namespace mpmvv::solver {

namespace detail {

template <int D>
Grid<D> make_grid(const Scene<D>& scene) {
  return std::visit(
      [&scene]<class B>(const B&) { return Grid<D>(scene.lower, scene.h, scene.cells, B::extra_inside, B::ghost); },
      scene.basis);
}

template <int D>
const Integrator<D>& find_integrator(std::string_view word) {
  for (const Integrator<D>& integrator : integrators<D>)
    if (integrator.word == word) return integrator;
  throw std::invalid_argument("unknown integrator '" + std::string(word) + "'");
}

}  // namespace detail

template <int D>
Mpm<D>::Mpm(Scene<D> scene)
    : scene_(std::move(scene)),
      particles_(std::move(scene_.particles)),
      grid_(detail::make_grid(scene_)),
      slabs_(grid_, reach(width_of(scene_.basis))),
      team_(scene_.threads),
      advance_(detail::find_integrator<D>(scene_.integrator).advance) {
  if (is_staged(scene_.integrator)) particles_.start_stages();
  if (detail::find_integrator<D>(scene_.integrator).kind == IntegratorKind::remapped)
    particles_.rate.resize(particles_.size());
  if (std::holds_alternative<Apic>(scene_.velocity_update)) particles_.C.assign(particles_.size(), Mat<D>::Zero());
  std::visit(
      [this]<class M>(const M& material) {
        if constexpr (has_history<M>) particles_.thermal.assign(particles_.size(), material.state_at_rest());
      },
      scene_.material);
  for (int d = 0; d < D; ++d)
    periodic_[static_cast<std::size_t>(d)] =
        std::holds_alternative<Periodic>(scene_.boundary[static_cast<std::size_t>(2 * d)]);
  double mass = 0, volume = 0;
  for (std::size_t p = 0; p < particles_.size(); ++p) mass += particles_.m[p], volume += particles_.V0[p];
  const double cell_mass = mass / volume * std::pow(grid_.h(), D);
  least_mass_ = scene_.mass_cutoff * cell_mass;
  if (scene_.surface_load) {
    place_.resize(particles_.size());
    load_.resize(scene_.surface_load->parts().size());
  }
  sort();
  add_walls();
  if (scene_.consistent_mass)
    consistent_mass_.emplace(*this, *scene_.consistent_mass, cell_mass);
  else if (expands_inverse(scene_.velocity_update))
    expanded_inverse_.emplace(grid_);
}

template <int D>
void Mpm<D>::add_walls() {
  for_faces([this]<class Boundary>(const Boundary& boundary, Face face) {
    if constexpr (std::is_same_v<Boundary, Wall>) {
      if (!boundary.motion) throw std::invalid_argument("a wall without a motion");
      std::vector<double> places;
      for (int i = -grid_.ghost(); i < grid_.nodes(face.axis) - grid_.ghost(); ++i) {
        Index<D> index{};
        index[static_cast<std::size_t>(face.axis)] = i;
        places.push_back(node_position(static_cast<std::size_t>(grid_.node(index)))[face.axis]);
      }
      walls_.emplace_back(boundary, face, grid_, places);
    }
  });
}

template <int D>
void Mpm<D>::sort() {
  slabs_.sort(particles_, grid_);
  if (!scene_.surface_load) return;
  for (std::uint32_t p = 0; p < particles_.size(); ++p) place_[particles_.id[p]] = p;
}

template <int D>
bool Mpm<D>::step(double dt) {
  const double end = time_ + dt;
  dt_ = dt;
  for (auto& wall : walls_) wall.move(time_, dt, grid_.h());
  advance_(*this, dt);
  ++steps_;
  time_ = end;
  sort_strays();
  return fault_ == Fault::none;
}

template <int D>
void Mpm<D>::sort_strays() {
  if (must_sort_.exchange(false)) sort();
}

template <int D>
void Mpm<D>::map_acceleration() {
  grid_.clear();
  sweep_with_forces(node_loop(), MapMass<D>{particles_, grid_});
  fold(grid_.p);
  set_grid_acceleration();
}

template <int D>
Vec<D> Mpm<D>::node_position(std::size_t n) const {
  const Index<D> i = grid_.index(n);
  Vec<D> x = grid_.lower();
  std::visit(
      [&]<class B>(const B&) {
        for (int d = 0; d < D; ++d)
          x[d] += grid_.h() * B::position(i[static_cast<std::size_t>(d)], grid_.cells()[static_cast<std::size_t>(d)]);
      },
      scene_.basis);
  return x;
}

template <int D>
std::string Mpm<D>::fault() const {
  if (contains(fault_, Fault::outside)) return "a particle left the domain";
  if (contains(fault_, Fault::outgrown))
    return width_of(scene_.basis) == ParticleWidth::domain
               ? "a corner of a particle is more than " + std::to_string(domain_reach) + " cells from it"
               : "a particle is wider than a cell";
  if (contains(fault_, Fault::inverted)) return "det F <= 0 on a particle";
  return "";
}

template <int D>
double Mpm<D>::mass() const {
  return std::accumulate(particles_.m.begin(), particles_.m.end(), 0.0);
}

template <int D>
Mat<D> Mpm<D>::stress(std::size_t p) const {
  return std::visit(
      [&]<class M>(const M& material) -> Mat<D> {
        if constexpr (has_history<M>)
          return -particles_.thermal[p].total_pressure() * Mat<D>::Identity();
        else {
          PackedMat<D> tau;
          material.kirchhoff(&particles_.F[p], &tau, 1);
          return tau.template topRows<D>() / particles_.F[p].determinant();
        }
      },
      scene_.material);
}

template <int D>
double Mpm<D>::kinetic_energy() const {
  double energy = 0;
  for (std::size_t p = 0; p < particles_.size(); ++p) energy += 0.5 * particles_.m[p] * particles_.v[p].squaredNorm();
  return energy;
}

template <int D>
double Mpm<D>::strain_energy() const {
  return std::visit(
      [this]<class M>(const M& material) {
        double energy = 0;
        for (std::size_t p = 0; p < particles_.size(); ++p)
          if constexpr (has_history<M>)
            energy += particles_.m[p] * particles_.thermal[p].energy;
          else
            energy += particles_.V0[p] * material.template energy<D>(particles_.F[p]);
        return energy;
      },
      scene_.material);
}

template <int D>
template <class Before, class... Map>
void Mpm<D>::sweep_with_forces(const Before& before, const Map&... map) {
  const EvaluateStress<D> stress{particles_, scene_.material, dt_};
  if (scene_.body_force && scene_.body_force_on == BodyForceOn::particles)
    sweep(before, stress, EvaluateBodyForce<D>{particles_, *scene_.body_force, time_},
          node_loop(map..., MapForces<D>{particles_, grid_}));
  else
    sweep(before, stress, node_loop(map..., MapInternalForce<D>{particles_, grid_}));
  if (scene_.surface_load) add_surface_load();
  fold(grid_.f);
}

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
void Mpm<D>::fold(std::vector<V>& field) {
  for_faces([&](const auto& boundary, Face face) { boundary.fold(grid_, face, field); });
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
void Mpm<D>::add_surface_load() {
  scene_.surface_load->forces(time_, load_.data());
  std::visit(
      [this](const auto& basis) {
        note(map_surface_load(swept(basis), *scene_.surface_load, load_.data(), place_, particles_, grid_));
      },
      scene_.basis);
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
