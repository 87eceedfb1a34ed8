#pragma once
#include <cmath>
#include <string_view>
#include <utility>

#include "solver/integrator/integrators.hpp"
#include "solver/mpm.hpp"
#include "solver/words.hpp"

/// Small scenes for the solver's tests and its benchmark.
namespace mpmvv::solver {

inline AnyBasis basis_named(std::string_view word) {
  AnyBasis basis;
  if (!from_word(word, basis)) throw std::invalid_argument(std::string(word));
  return basis;
}

/// Particles with these positions, each of the given volume, of unit density, at rest and undeformed.
template <int D>
Particles<D> particles_at(const Array<Vec<D>>& x, double volume) {
  Particles<D> particles;
  particles.resize(x.size());
  particles.x = x;
  particles.v.assign(x.size(), Vec<D>::Zero());
  particles.F.assign(x.size(), Mat<D>::Identity());
  particles.m.assign(x.size(), volume);
  particles.V0.assign(x.size(), volume);
  return particles;
}

/// Centres of the boxes of side `spacing` that fill `count` of them along each axis from `lower` on.
template <int D>
Array<Vec<D>> lattice(const Vec<D>& lower, double spacing, const Index<D>& count) {
  std::size_t total = 1;
  for (const int n : count) total *= static_cast<std::size_t>(n);
  Array<Vec<D>> x(total);
  for (std::size_t k = 0; k < total; ++k) {
    int rest = static_cast<int>(k);
    for (int d = 0; d < D; ++d) {
      const int n = count[static_cast<std::size_t>(d)];
      x[k][d] = lower[d] + spacing * (rest % n + 0.5);
      rest /= n;
    }
  }
  return x;
}

/// Gives the particles the widths that the basis asks for.
template <int D>
void set_widths(Scene<D>& scene, double width) {
  auto& particles = scene.particles;
  const ParticleWidth kind = width_of(scene.basis);
  if (kind == ParticleWidth::reference || kind == ParticleWidth::current)
    particles.l.assign(particles.size(), Vec<D>::Constant(width));
  if (kind == ParticleWidth::current) particles.l0 = particles.l;
  if (kind == ParticleWidth::domain) particles.R.assign(particles.size(), width * Mat<D>::Identity());
  particles.R0 = particles.R;
}

/// The unit interval, square or cube of `cells` cells along each axis, filled with ppc^D particles per cell at rest.
template <int D>
Scene<D> full_scene(const AnyBasis& basis, int cells, int ppc, const AnyBoundary& boundary = Periodic{}) {
  Scene<D> scene;
  scene.h = 1.0 / cells;
  scene.cells.fill(cells);
  scene.basis = basis;
  scene.material = NeoHookeanLog{3000, 4000};
  scene.boundary.fill(boundary);
  scene.least_in_slab = 1;  // several slabs also of few particles
  Index<D> count;
  count.fill(cells * ppc);
  scene.particles = particles_at<D>(lattice<D>(scene.lower, scene.h / ppc, count), std::pow(scene.h / ppc, D));
  set_widths(scene, 1.0 / ppc);
  return scene;
}

/// The consistent mass matrix as it is, solved to round-off: for scenes that leave it regular.
inline constexpr ConsistentMassSettings unregularised{.lumped_share = 1e-12, .covered = 0, .tolerance = 1e-13};

template <int D>
Scene<D> with_consistent_mass(Scene<D> scene) {
  scene.consistent_mass.emplace();
  return scene;
}

/// A smooth periodic velocity of this amplitude, the same in every component.
template <int D>
void set_wave(Scene<D>& scene, double amplitude) {
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    scene.particles.v[p].setConstant(amplitude * std::sin(2 * M_PI * scene.particles.x[p].sum()));
}

}  // namespace mpmvv::solver
