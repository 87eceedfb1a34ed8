#pragma once
#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "solver/integrator/integrators.hpp"
#include "solver/mpm_grid.hpp"
#include "solver/mpm_sweeps.hpp"

namespace mpmvv::solver {

namespace detail {

template <int D>
Grid<D> make_grid(const Scene<D>& scene) {
  return std::visit(
      [&scene]<class B>(const B&) { return Grid<D>(scene.lower, scene.h, scene.cells, B::extra_inside, B::ghost); },
      scene.basis);
}

template <int D>
Scene<D> sound(Scene<D> scene) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  const Particles<D>& particles = scene.particles;
  const ParticleWidth width = width_of(scene.basis);
  const bool is_wide = width == ParticleWidth::reference || width == ParticleWidth::current;
  require(particles.size() > 0, "a scene without particles");
  require(scene.threads > 0, "a scene without threads");
  require(!is_wide || particles.l.size() == particles.size(), "particles without the widths that the basis takes");
  require(width != ParticleWidth::domain || particles.R.size() == particles.size(),
          "particles without the domains that the basis takes");
  for (const AnyBoundary& boundary : scene.boundary)
    if (const auto* wall = std::get_if<Wall>(&boundary)) require(wall->motion, "a wall without a motion");
  return scene;
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
    : scene_(detail::sound(std::move(scene))),
      particles_(std::move(scene_.particles)),
      grid_(detail::make_grid(scene_)),
      slabs_(std::visit([this](const auto& basis) { return Slabs<D>(grid_, basis); }, scene_.basis)),
      team_(scene_.threads),
      active_nodes_(grid_.size()),
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
  least_mass_ = scene_.mass_cutoff.value_or(mass_cutoff_of(scene_.basis)) * cell_mass;
  if (scene_.surface_load) {
    place_.resize(particles_.size());
    load_.resize(scene_.surface_load->parts().size());
  }
  sort();
  add_walls();
  if (scene_.consistent_mass)
    consistent_mass_ = std::make_unique<ConsistentMass<D>>(*this, *scene_.consistent_mass, cell_mass);
  else if (const int order = expansion_order(scene_.velocity_update); order > 0)
    expanded_inverse_ = std::make_unique<ExpandedInverse<D>>(*this, order);
}

template <int D>
Mpm<D>::~Mpm() = default;

template <int D>
void Mpm<D>::add_walls() {
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
void Mpm<D>::sort() {
  slabs_.sort(particles_, grid_, team_);
  ++moves_;
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
               : "the width of a particle is not between zero and a cell";
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
        else
          return material.kirchhoff(particles_.F[p]) / particles_.F[p].determinant();
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

}  // namespace mpmvv::solver
