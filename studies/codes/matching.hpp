#pragma once
#include <vector>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/score.hpp"

namespace mpmvv::codes {

/// Which of the case's particles each line of the output's end is, one to one: by its id. OutputFault where particles
/// are missing or doubled, or where nothing tells which is which.
template <int D>
std::vector<std::size_t> match(const CaseParticles<D>& particles, const Output& output);

extern template std::vector<std::size_t> match<1>(const CaseParticles<1>&, const Output&);
extern template std::vector<std::size_t> match<2>(const CaseParticles<2>&, const Output&);
extern template std::vector<std::size_t> match<3>(const CaseParticles<3>&, const Output&);

}  // namespace mpmvv::codes
