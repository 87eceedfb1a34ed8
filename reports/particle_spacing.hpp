#pragma once
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::reports {

/// The width, in m, of squares that stand for the particles' shares of the body: the spacing of a lattice, also of a
/// single row, and somewhat more where a lattice is stretched, so that few gaps are left. Nothing tells a lone
/// particle's share: its square is that of a body that reaches from the origin to beyond the particle, in whose middle
/// it is. There has to be a particle.
double particle_spacing(const std::vector<records::ParticleError>& particles);

}  // namespace mpmvv::reports
