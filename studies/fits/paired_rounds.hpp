#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace mpmvv::fits {

/// What a case cost each time that it was timed. The cases of a session take turns, so that the k-th round of one met
/// the same spell of the machine as the k-th of another.
struct Rounds {
  std::vector<double> costs;  ///< in the order of the rounds
  std::string session;        ///< empty where nothing was timed

  bool operator==(const Rounds&) const = default;
};

/// Exp of the mean of logarithms; all must be positive.
double geometric_mean(std::span<const double> values);

/// Whether all were timed in the same rounds, three or more.
bool are_paired(std::span<const Rounds> all);

/// A number and where it may lie.
struct Estimate {
  double value, lower, upper;
};

/// A number computed from one cost per case: from the geometric means over paired rounds. The interval is the 95 % one
/// of the jackknife over the rounds, with Student's t of n - 1 degrees of freedom; it is taken of the number's
/// logarithm where the number is positive whichever round is left out. Where it is not finite for one of these, the
/// number may lie anywhere.
Estimate over_rounds(std::span<const Rounds> paired, const std::function<double(std::span<const double>)>& number);

}  // namespace mpmvv::fits
