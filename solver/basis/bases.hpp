#pragma once
#include <variant>

#include "solver/basis/b2cpdi.hpp"
#include "solver/basis/b2gimp.hpp"
#include "solver/basis/bspline.hpp"
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

static_assert([]<Basis... B>(const std::variant<B...>*) { return true; }(static_cast<const AnyBasis*>(nullptr)));

inline ParticleWidth width_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::width; }, basis);
}

/// Returns the mass, as a fraction of a full cell's, up to which a node has no acceleration. The force on such a node
/// is lost to the body's momentum. A particle whose support overlaps a node by e cells gives the node a mass of order
/// e² and a force of order e, or of higher powers. So the cutoff loses at most 1e-8 of a force, and that seldom. With
/// `linear` the mass is of order e and the force of order one, with `cpdi` both are of order e. They have a
/// `mass_cutoff` of their own, well above the round-off of a position.
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
