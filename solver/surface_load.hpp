#pragma once
#include <cstdint>
#include <span>

#include "solver/types.hpp"

namespace mpmvv::solver {

/// Forces on parts of the body's surface, each of which moves with the particle that it bounds.
template <int D>
class SurfaceLoad {
 public:
  struct Part {
    std::uint32_t particle;  ///< id
    Vec<D> offset;           ///< of its middle from the particle, at rest
  };

  virtual ~SurfaceLoad() = default;
  virtual std::span<const Part> parts() const = 0;
  virtual void forces(double t, Vec<D>* f) const = 0;  ///< N, one per part
};

}  // namespace mpmvv::solver
