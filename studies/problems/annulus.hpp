#pragma once
#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

// What the problems on rings and shells share.
inline double outer_radius(const Parameters& p) {
  return p.at("outer_radius");
}
/// With a lateral contraction the surfaces, where F_RR = 1, carry the normal stress λ ln J.
inline bool has_poissons_ratio(const Parameters& p) {
  return p.at("poissons_ratio") != 0;
}

}  // namespace mpmvv::problems
