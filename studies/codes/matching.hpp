#pragma once
#include <vector>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/score.hpp"

namespace mpmvv::codes {

/// Which of the case's particles each line of the output's end is, one to one, by what is there:
///   - its reference position, that which is written or x - u, which lies at that of a particle of the case;
///   - its id, which names a line of the start, or else the case's particles from 1 on;
///   - its place in the file, which is that of the start, or else that of the case's particles; or the nearest position
///     at time zero. Of these one is taken only where every particle bears it out: by less than half a particle spacing
///     from where the exact solution has it, or from where it was.
/// A start's lines are found by reference position, else by where they are at time zero. OutputFault where particles
/// are missing or doubled or start elsewhere than the case's, or where nothing tells which is which.
template <int D>
std::vector<std::size_t> match(const CaseParticles<D>& particles, const Output& output);

extern template std::vector<std::size_t> match<1>(const CaseParticles<1>&, const Output&);
extern template std::vector<std::size_t> match<2>(const CaseParticles<2>&, const Output&);
extern template std::vector<std::size_t> match<3>(const CaseParticles<3>&, const Output&);

}  // namespace mpmvv::codes
