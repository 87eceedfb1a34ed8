#pragma once
#include <stdexcept>

namespace mpmvv::mms {

/// The inner and outer radius of a ring or shell about the origin, m. The constructor throws std::invalid_argument
/// unless 0 < R_I < R_O.
struct Radii {
  Radii(double inner_radius, double outer_radius) : inner(inner_radius), outer(outer_radius) {
    if (!(0 < inner && inner < outer))
      throw std::invalid_argument("the inner radius has to be positive and below the outer radius");
  }

  double inner, outer;
};

}  // namespace mpmvv::mms
