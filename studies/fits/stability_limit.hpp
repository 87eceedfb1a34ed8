#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/support/not_measured.hpp"

namespace mpmvv::fits {

/// One probe of a limit search.
struct Probe {
  double value = 0;
  bool stable = false;
  std::string reason;
  std::int64_t steps = 0;  ///< of the run, to its end or to where it blew up; 0: not known, as in older stores
};

/// Stability limit of the runs that were made, by scan and bisection: all runs tried from the stable end to `stable`
/// are stable, none from `unstable` on is. Runs of more steps may have another limit: an instability has to grow from
/// round-off before the run ends.
struct StabilityLimit {
  std::string key;                          ///< what was varied: `cfl`, `smoothing_length`
  double stable = support::not_measured;    ///< NaN: the stable end itself is unstable
  double unstable = support::not_measured;  ///< NaN: nothing is unstable
  bool monotone = true;                     ///< false: a stable probe lies beyond an unstable one
  bool found = false;                       ///< whether both ends are known
  std::vector<Probe> probes;                ///< in increasing value

  double value() const { return (stable + unstable) / 2; }
};

/// Steps of the run at the stable end of the bracket; 0 where none is known.
std::int64_t steps_at_limit(const StabilityLimit& limit);

/// The growth per step that takes round-off, 1e-12 of what is measured, to all of it in so many steps: a slower
/// instability goes unseen. NaN where the steps are not known (0).
double least_visible_growth(std::int64_t steps);

/// The fewest steps after which a run counts as stable: an instability that doubles on every step shows in them.
inline constexpr std::int64_t enough_steps = 40;

/// Where a limit may lie: between its ends, or beyond all that was tried, where one end alone is known.
struct LimitRange {
  double lower = 0, upper = 0;  ///< 0 and infinity where nothing is known
  bool stable_below = true;

  bool is_open() const;  ///< on one side
};

/// None where neither end is known, or where all that was tried is one value, which does not tell the sides apart.
std::optional<LimitRange> range_of(const StabilityLimit& limit);

/// The same, with a stable end whose run has `enough_steps` or a number of them that is not known: shorter runs do not
/// show that the limit lies beyond them.
std::optional<LimitRange> sure_range_of(const StabilityLimit& limit);

/// Says what is known where no limit was found: that all runs were stable, or all unstable, and up or down to which
/// value; or that the runs differ.
std::string text_without_limit(const StabilityLimit& limit);

/// Says that the run at the stable end has fewer than `enough_steps`; empty where it has not.
std::string too_few_steps(const StabilityLimit& limit);

/// How a limit is searched: a geometric scan of [from, to], both ends included, then bisection of one bracket.
struct LimitSearch {
  std::string key;  ///< what is varied: `cfl`, `smoothing_length`
  double from = 0, to = 0;
  double scan_ratio = 1.1;   ///< > 1; neighbouring scan values differ by this factor at most
  double tolerance = 0.01;   ///< the search ends when |unstable - stable| <= tolerance * stable, if runs are so close
  bool stable_below = true;  ///< cfl: stable below the limit; smoothing_length: stable above it
};

/// UsageError that says which number of the search makes no sense, and what would.
void require_sound(const LimitSearch& search);

/// The values of the scan: equal ratios, at most `scan_ratio`, with the ends exactly as given.
std::vector<double> scan_values(const LimitSearch& search);

/// Probes a batch of values; one verdict per value, in order, each with the value that was run, which may be another
/// than the one asked for (a time step divides the end time). The search hands over the scan as one batch so that
/// the caller can spread it over the cores.
using ProbeBatch = std::function<std::vector<Probe>(const std::vector<double>&)>;

/// Scans, then bisects between the first unstable value met from the stable end and its stable neighbour. Then probes
/// 1, 2 and 5 tolerances to either side of the bracket: near a limit stability is often not monotone. If one of them on
/// the stable side is unstable, bisects there. A stable probe beyond an unstable one makes the limit non-monotone:
/// then it bisects the far end, too, and the bracket reaches from the last value up to which all are stable to the
/// first one from which none is. Every probe is kept once, in increasing value. Bracket and probes are of what was run;
/// where no run lies between its ends, the bracket may be wider than the tolerance.
///
/// Not found when the farthest value tried is stable (`unstable` is NaN then; where nothing is unstable, `stable` is
/// that value) or when the stable end itself is unstable (`stable` is NaN). The verdict is yes or no, so this bisects
/// by itself: Boost.Math's root finders want values and return NaN where they are infinite. Throws UsageError on a
/// search that cannot be carried out.
StabilityLimit find_limit(const LimitSearch& search, const ProbeBatch& probe);

/// The common limit of replicates, of which there must be at least one: below its bracket all of them are stable, above
/// it none is (for `smoothing_length` the other way round), as far as each one's limit says. An end of the bracket is
/// NaN where one replicate lacks it. Found where each limit is, and monotone where each is.
StabilityLimit common_limit(const std::vector<StabilityLimit>& replicates, bool stable_below);

}  // namespace mpmvv::fits
