#pragma once
#include <string_view>
#include <vector>

namespace mpmvv::solver {

/// Words of the integrators, in the order of the table.
std::vector<std::string_view> integrator_words();
/// Whether particle velocities live half a step before the positions.
bool is_staggered(std::string_view integrator);
/// Whether it keeps two more states of the particles.
bool is_staged(std::string_view integrator);

}  // namespace mpmvv::solver
