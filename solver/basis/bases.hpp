#pragma once
#include <variant>

#include "solver/basis/b2cpdi.hpp"
#include "solver/basis/b2gimp.hpp"
#include "solver/basis/cpdi.hpp"
#include "solver/basis/gimp.hpp"
#include "solver/basis/linear.hpp"
#include "solver/basis/open_bspline.hpp"

namespace mpmvv::solver {

/// The one place where bases are named: add a line here for a new one.
using AnyBasis = std::variant<Linear,        //
                              BSpline2,      //
                              BSpline3,      //
                              BSpline2Open,  //
                              BSpline3Open,  //
                              UGimp,         //
                              Gimp,          //
                              CpGimp,        //
                              Cpdi,          //
                              B2Gimp,        //
                              B2Cpdi>;

inline ParticleWidth width_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::width; }, basis);
}

/// The mass, as a fraction of a full cell's, up to which a node has no acceleration. What a particle gives a node that
/// its support overlaps by e cells vanishes with e² or faster, and the force with e: up to e = 1e-8 it is lost to the
/// body's momentum, which is round-off. With hats mass vanishes with e, and force not at all.
inline double mass_cutoff_of(const AnyBasis& basis) {
  return std::visit(
      []<class B>(const B&) {
        if constexpr (requires { B::mass_cutoff; })
          return B::mass_cutoff;
        else
          return 1e-16;
      },
      basis);
}

inline int ghosts_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::ghost; }, basis);
}

}  // namespace mpmvv::solver
