#pragma once
#include <vector>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/score.hpp"

/// What can be wrong with an output though every file of it can be read; each an OutputFault.
namespace mpmvv::codes {

/// What files say of their run is what the case has: problem, parameters, resolution, form of the body force.
void require_same_case(const cases::Case& c, const Snapshot& s);

/// The file says no other time than the case's end time.
void require_end_time(const cases::Case& c, const Snapshot& s);

/// All numbers are finite; `unstable` otherwise, where none of so many particles is missing.
void require_finite(const Snapshot& s, std::size_t particles);

/// An end as far as it is known which particle each line is.
template <int D>
struct MatchedEnd {
  const CaseParticles<D>& particles;
  const Snapshot& snapshot;
  std::vector<std::size_t> particle;  ///< of each line
  std::vector<Vec<D>> u;              ///< of each line

  std::size_t size() const { return particle.size(); }
  Vec<D> x(std::size_t line) const {
    return snapshot.x.empty() ? Vec<D>(particles.X[particle[line]] + u[line]) : vec<D>(snapshot.x[line]);
  }
  /// The way from where the particle should be at time t.
  Vec<D> error(std::size_t line, double t) const {
    const Vec<D>& X = particles.X[particle[line]];
    return particles.difference(u[line], particles.setup.solution->u(X, t));
  }
};

/// Positions and displacements are no thousand times, or so, those of the exact solution.
template <int D>
void require_length_units(const MatchedEnd<D>& end);

/// Nor are velocities, where the file has some.
template <int D>
void require_velocity_units(const MatchedEnd<D>& end);

/// For behind the reason of an unstable end: the vector by which its particles are all off, where nearly all that is
/// wrong with them is one; empty otherwise.
template <int D>
std::string common_offset(const MatchedEnd<D>& end);

/// No particle is a cell or more outside the grid; `unstable` otherwise.
template <int D>
void require_inside(const MatchedEnd<D>& end);

/// There is no other time, up to twice the end time and 8 per cent of it away, whose exact solution fits five times
/// better, where the error is more than a fiftieth of the displacements.
template <int D>
void require_time(const MatchedEnd<D>& end);

/// Particles have moved since time zero, beyond the file's digits, where those of the exact solution do.
template <int D>
void require_motion(const MatchedEnd<D>& end);

/// The mass is that of the case's particles, within two per cent.
template <int D>
void require_mass(const MatchedEnd<D>& end);

}  // namespace mpmvv::codes
