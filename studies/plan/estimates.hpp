#pragma once
#include "studies/cases/case.hpp"

namespace mpmvv::plan {

/// Number of particles times steps, more for an expanded inverse: to run long cases first.
double work_estimate(const cases::Case& c);

/// Seconds assumed for every check, as the store keeps no times of checks; the longest take a few.
inline constexpr double about_check = 5;

/// The share of a case's time in which it has the machine for itself, for its cost to be measured; the first of its
/// runs is beside others.
double share_alone(const cases::Case& c);

/// Whether threads can share a case of which one of every `images` particles is run: our solver's, with particles for
/// three slabs, of which two are visited at a time.
bool can_be_shared(const cases::Case& c, int images = 1);

/// Whether a case that takes so many seconds on one core gets all threads: it takes long, and would still run when
/// `all` seconds of work, its own among them, are done.
bool outlasts_others(double seconds, double all, int jobs);

/// Upper estimate of the memory, in bytes, that a run of this case takes when only one of every `images` particles is
/// run.
double memory_estimate(const cases::Case& c, int images = 1);

}  // namespace mpmvv::plan
