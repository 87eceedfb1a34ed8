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

template <Boundary... B>
constexpr void require_boundaries(const std::variant<B...>*) {}
static_assert((require_boundaries(static_cast<const AnyBoundary*>(nullptr)), true));

}  // namespace mpmvv::solver
