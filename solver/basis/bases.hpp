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

inline int ghosts_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::ghost; }, basis);
}

}  // namespace mpmvv::solver
