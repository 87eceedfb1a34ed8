#pragma once
#include <vector>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/score.hpp"

namespace mpmvv::codes {

/// Requires that no particle is missing or doubled, as far as numbers of lines and ids tell: positions may be no
/// numbers. The fault is `failed`.
void require_each_once(const Output& output, std::size_t particles);

/// Returns for each line of the output's end which of the case's particles it is, one to one. It goes by the first of
/// these that the output has:
///   - the reference position, X or x - u, which has to be that of a particle of the case;
///   - the id: that of a line of the start if there is a start, else the case's own, which count from 1. The latter
///   must
///     not be contradicted by the positions: that these fit the exact solution, but only with other ids;
///   - the order of the lines, which is that of the start if there is one, else that of the case's particles. It counts
///     only if every particle is less than half a particle spacing from its exact position;
///   - the position: each is the particle that was nearest at time zero, if all are less than half a spacing from it.
/// The lines of the start are matched by reference position, else by their position at time zero. Throws OutputFault if
/// particles are missing, doubled or start elsewhere than those of the case, or if nothing tells which is which.
template <int D>
std::vector<std::size_t> match(const CaseParticles<D>& particles, const Output& output);

extern template std::vector<std::size_t> match<1>(const CaseParticles<1>&, const Output&);
extern template std::vector<std::size_t> match<2>(const CaseParticles<2>&, const Output&);
extern template std::vector<std::size_t> match<3>(const CaseParticles<3>&, const Output&);

}  // namespace mpmvv::codes
