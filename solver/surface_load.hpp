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
    std::uint32_t particle;  ///< id of the particle
    Vec<D> offset;           ///< from the particle to the middle of the part, at rest, m
  };

  virtual ~SurfaceLoad() = default;
  virtual std::span<const Part> parts() const = 0;     ///< the same in every call
  virtual void forces(double t, Vec<D>* f) const = 0;  ///< writes the force on each part, N
};

}  // namespace mpmvv::solver
