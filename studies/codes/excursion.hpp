#pragma once
#include "studies/codes/case_particles.hpp"

namespace mpmvv::codes {

/// How far the exact solution is from where it starts: RMS over the particles, or a sample of 250 or more, in m.
struct Excursion {
  double farthest = 0;  ///< the largest at 20 times up to the end time
  double time = 0;      ///< the time of that, s
  double at_end = 0;
};

template <int D>
Excursion excursion(const CaseParticles<D>& particles);

extern template Excursion excursion<1>(const CaseParticles<1>&);
extern template Excursion excursion<2>(const CaseParticles<2>&);
extern template Excursion excursion<3>(const CaseParticles<3>&);

}  // namespace mpmvv::codes
