#pragma once
#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

// Functions that the problems on rings and shells share.
inline double outer_radius(const Parameters& p) {
  return p.at("outer_radius");
}
/// Whether Poisson's ratio is not zero. Then the surfaces, where F_RR = 1, carry the normal stress λ ln J.
inline bool has_poissons_ratio(const Parameters& p) {
  return p.at("poissons_ratio") != 0;
}

}  // namespace mpmvv::problems
