#pragma once
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::reports {

/// The width, in m, of a square that is a particle's share of the body, in a lattice of any direction as in a single
/// row: the lower quartile of the spacings around the particles, which come out too large at edges. Nothing tells a
/// lone particle's: it is that of a body that reaches from the origin to beyond the particle, in whose middle it is.
/// There has to be a particle.
double particle_spacing(const std::vector<records::ParticleError>& particles);

}  // namespace mpmvv::reports
