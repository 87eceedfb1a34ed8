#include "solver/step.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "solver/integrator/integrators.hpp"
#include "solver/step_grid.hpp"
#include "solver/step_sweeps.hpp"

namespace mpmvv::solver {

namespace {

template <int D>
Grid<D> make_grid(const Scene<D>& scene) {
  return std::visit(
      [&scene]<class B>(const B&) { return Grid<D>(scene.lower, scene.h, scene.cells, B::extra_inside, B::ghost); },
      scene.basis);
}

template <int D>
Scene<D> sound(Scene<D> scene) {
  require_sound(scene);
  return scene;
}

/// Returns the mean mass density of the particles at rest times the volume of a cell.
template <int D>
double full_cell_mass(const Particles<D>& particles, double h) {
  double mass = 0, volume = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) mass += particles.m[p], volume += particles.V0[p];
  return mass / volume * std::pow(h, D);
}

}  // namespace

template <int D>
Step<D>::Step(Scene<D> scene)
    : scene_(sound(std::move(scene))),
      particles_(std::move(scene_.particles)),
      grid_(make_grid(scene_)),
      slabs_(std::visit(
          [this](const auto& basis) { return Slabs<D>(grid_, basis, particles_.size() / scene_.least_in_slab); },
          scene_.basis)),
      pool_(scene_.threads),
      orbits_(scene_.images, grid_),
      active_nodes_(grid_.size()),
      integrator_(integrator_named(scene_.integrator)) {
  make_room();
  for (int d = 0; d < D; ++d)
    periodic_[static_cast<std::size_t>(d)] =
        std::holds_alternative<Periodic>(scene_.boundary[static_cast<std::size_t>(2 * d)]);
  const double cell_mass = full_cell_mass(particles_, grid_.h());
  least_mass_ = scene_.mass_cutoff.value_or(mass_cutoff_of(scene_.basis)) * cell_mass;
  sort();
  add_walls();
  if (needs_whole_orbits()) orbits_.take_all(grid_);
  if (scene_.consistent_mass)
    consistent_mass_ = std::make_unique<ConsistentMass<D>>(*this, *scene_.consistent_mass, cell_mass);
  else if (const int order = expansion_order(scene_.velocity_update); order > 0)
    expanded_inverse_ = std::make_unique<ExpandedInverse<D>>(*this, order);
}

template <int D>
Step<D>::~Step() = default;

/// Makes room for the fields that only some schemes have, and leaves the others empty: particles may come from a run
/// with another scheme.
template <int D>
void Step<D>::make_room() {
  const std::size_t n = particles_.size();
  particles_.stages = {};
  if (integrator_.is_staged) particles_.start_stages();
  particles_.rate.resize(integrator_.is_remapped ? n : 0);
  particles_.C.assign(has_affine_field(scene_.velocity_update) ? n : 0, Mat<D>::Zero());
  particles_.thermal.clear();
  std::visit(
      [this, n]<class M>(const M& material) {
        if constexpr (has_history<M>) {
          particles_.thermal.resize(n);
          for (std::size_t p = 0; p < n; ++p) particles_.thermal[p] = material.state_at(particles_.F[p].determinant());
        }
      },
      scene_.material);
  if (!scene_.surface_load) return;
  place_.resize(n);
  load_.resize(scene_.surface_load->parts().size());
}

template <int D>
void Step<D>::add_walls() {
  for_faces([this]<class Boundary>(const Boundary& boundary, Face face) {
    if constexpr (std::is_same_v<Boundary, Wall>) {
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
std::int64_t Step<D>::advance(double dt, std::int64_t steps) {
  const std::int64_t before = steps_;
  for (std::int64_t k = 0; k < steps && fault_ == Fault::none; ++k) step(dt);
  finish_waiting();
  return steps_ - before;
}

template <int D>
void Step<D>::step(double dt) {
  const double start = time_;
  dt_ = dt;
  for (auto& wall : walls_) wall.move(start, dt, grid_.h());
  integrator_.page<D>()(*this, dt);
  time_ = is_late_ ? start : start + dt;
  if (!is_late_) ++steps_;
}

template <int D>
void Step<D>::sort() {
  slabs_.sort(particles_, grid_, pool_);
  ++moves_;
  if (!scene_.surface_load) return;
  for (std::uint32_t p = 0; p < particles_.size(); ++p) place_[particles_.id[p]] = p;
}

template <int D>
Vec<D> Step<D>::node_position(std::size_t n) const {
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

template class Step<1>;
template class Step<2>;
template class Step<3>;

}  // namespace mpmvv::solver
