#pragma once

namespace mpmvv::solver {

/// How the consistent mass matrix is kept from being singular, and how far its systems are solved. Displacement errors
/// of the bar and the square change by a few per cent at most with ε <= 1e-2 or θ from 0.1 to 0.3 (tests show it).
/// Symbols are those of `ConsistentMass`.
struct ConsistentMassSettings {
  double lumped_share = 1e-2;  ///< ε, the share of diag(m) in M̂
  double covered = 0.25;       ///< θ, a fraction of a full cell's mass: a node with less passes to the lumped mass
  double tolerance = 1e-5;     ///< residual over that of the lumped solution, both in the norm of (Cᵀ diag(m) C)⁻¹
};

}  // namespace mpmvv::solver
