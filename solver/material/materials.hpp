#pragma once
#include <variant>

#include "solver/material/linear_elastic.hpp"
#include "solver/material/mie_gruneisen.hpp"
#include "solver/material/neo_hookean_log.hpp"
#include "solver/material/neo_hookean_square.hpp"

namespace mpmvv::solver {

/// The one place where materials are named: add a line here for a new one.
using AnyMaterial = std::variant<NeoHookeanLog,     //
                                 NeoHookeanSquare,  //
                                 LinearElastic,     //
                                 MieGruneisen>;

}  // namespace mpmvv::solver
