#pragma once
#include <cstdint>
#include <span>

#include "solver/basis/linear.hpp"
#include "solver/block.hpp"

namespace mpmvv::solver {

/// Forces on parts of the body's surface: the surface integral of the traction in f_i^ext, each part of the surface
/// taken at its middle, which lies at x_p + F_p offset of the particle that it bounds.
template <int D>
class SurfaceLoad {
 public:
  struct Part {
    std::uint32_t particle;  ///< id
    Vec<D> offset;           ///< from the particle, at rest
  };

  virtual ~SurfaceLoad() = default;
  virtual std::span<const Part> parts() const = 0;
  virtual void forces(double t, Vec<D>* f) const = 0;  ///< N, one per part
};

/// The weights of a point. Where those of a particle are averages over its domain, these are the averaged hats.
template <class B>
auto point_basis(const B& basis) {
  if constexpr (B::width == ParticleWidth::none)
    return basis;
  else
    return Linear{};
}

/// f_i += Σ N_i(x) force; returns `outside` when a part has left the grid.
template <int D, class B>
Fault map_surface_load(const B& basis, const SurfaceLoad<D>& load, const Vec<D>* force,
                       const std::vector<std::uint32_t>& place, const Particles<D>& particles, Grid<D>& grid) {
  int outside = 0;
  for (const auto& part : load.parts()) {
    const std::size_t p = place[part.particle];
    const Vec<D> x = particles.x[p] + particles.F[p] * part.offset;
    weights_at(x, basis, grid, outside).scatter(packed<D>(*force++), grid.f);
  }
  return outside > 0 ? Fault::outside : Fault::none;
}

}  // namespace mpmvv::solver
