#pragma once
#include <variant>

#include "solver/boundary/dirichlet.hpp"
#include "solver/boundary/free.hpp"
#include "solver/boundary/mirror.hpp"
#include "solver/boundary/periodic.hpp"
#include "solver/boundary/symmetry.hpp"
#include "solver/boundary/wall.hpp"

namespace mpmvv::solver {

/// The one place where boundaries are named: add a line here for a new one.
using AnyBoundary = std::variant<Periodic,   //
                                 Dirichlet,  //
                                 Symmetry,   //
                                 Mirror,     //
                                 Free,       //
                                 Wall>;

static_assert([]<Boundary... B>(const std::variant<B...>*) { return true; }(static_cast<const AnyBoundary*>(nullptr)));

}  // namespace mpmvv::solver
