#pragma once
#include <vector>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/score.hpp"

/// Checks of an output whose files could all be read. A function `require_...` throws an OutputFault if they fail.
namespace mpmvv::codes {

/// Requires that what a file says of its run agrees with the case: problem, parameters, resolution, boundary, material,
/// form of the body force. Methods are the code's own, and so are its words for them. Values with a unit are not
/// compared where the file has units of its own.
void require_same_case(const cases::Case& c, const Snapshot& s);

/// Requires that the step in the file, if it has one, is the case's last. Step 0 says nothing: some codes write it into
/// all their files.
void require_last_step(const cases::Case& c, const Snapshot& s);

/// Whether a time in s is the case's end time: to a thousandth of a time step or to 2e-6 of it, as a time is printed.
bool is_end_time(const cases::Case& c, double time);

/// Requires that the time in the file, if it has one, is the case's end time.
void require_end_time(const cases::Case& c, const Snapshot& s);

/// Requires that all positions, displacements and velocities are finite. The fault is `unstable`, but `failed` where
/// one of `particles` particles is missing or doubled (`require_each_once`).
void require_finite(const Output& output, std::size_t particles);

/// The end of an output with the particle that each line is.
template <int D>
struct MatchedEnd {
  const CaseParticles<D>& particles;
  const Snapshot& snapshot;
  std::vector<std::size_t> particle;  ///< the particle of each line
  std::vector<Vec<D>> u;              ///< the displacement of each line

  std::size_t size() const { return particle.size(); }
  Vec<D> x(std::size_t line) const {
    return snapshot.x.empty() ? Vec<D>(particles.X[particle[line]] + u[line]) : vec<D>(snapshot.x[line]);
  }
  /// Returns the displacement of the line less the exact one at time t, the shortest such vector in a periodic grid.
  Vec<D> error(std::size_t line, double t) const {
    const Vec<D>& X = particles.X[particle[line]];
    return particles.difference(u[line], particles.setup.solution->u(X, t));
  }
};

/// Requires that positions and displacements are in the right unit: not about 1000, 100, 0.01 or 0.001 times those of
/// the exact solution, to five per cent; displacements that are written without positions to a quarter.
template <int D>
void require_length_units(const MatchedEnd<D>& end);

/// Requires the same of velocities, if the file has any, to a factor of two: a coarse grid may be far off. Where those
/// of the exact solution are small at the end, nothing is required. Displacements should have been found to be right,
/// as those of a run that blows up may be of any size.
template <int D>
void require_velocity_units(const MatchedEnd<D>& end);

/// Returns a text to add to the reason of an unstable end, which asks whether the code has another origin: if all
/// particles are off by about the same vector (to 10 per cent of its length), it gives the vector. Empty otherwise.
template <int D>
std::string common_offset(const MatchedEnd<D>& end);

/// Requires that every particle is inside the grid or less than a cell outside. Axes along which the grid is periodic
/// are not looked at. The fault is `unstable`.
template <int D>
void require_inside(const MatchedEnd<D>& end);

/// Requires that the output is not of another time: where its error is more than a fiftieth of the displacements, the
/// exact solution must not fit it more than five times better at any time up to twice the end time that is more than 8
/// per cent of the end time, and 1.5 time steps, from the end time.
template <int D>
void require_time(const MatchedEnd<D>& end);

/// Requires that the particles are not where they were at time zero, to the file's rounding, if the exact solution
/// moves before the end time. It is a fault, too, if the exact solution is back at its start: then nothing can be told.
template <int D>
void require_motion(const MatchedEnd<D>& end);

/// Requires that masses, if the file has any, are positive and their sum is that of the case within two per cent.
template <int D>
void require_mass(const MatchedEnd<D>& end);

}  // namespace mpmvv::codes
