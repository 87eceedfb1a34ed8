#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/support/not_measured.hpp"

namespace mpmvv::fits {

using support::not_measured;

/// Order between two neighbouring points.
struct SegmentOrder {
  double from = 0, to = 0;  ///< swept values
  double order = 0;
};

/// e = C h^p + E0 (docs/measuring.md, "Floor"). The values stand even when the fit is not `accepted`.
struct FloorFit {
  double constant = not_measured, order = not_measured, floor = not_measured;
  double residual = not_measured;  ///< root mean square of the relative misfit
  bool accepted = false;
  std::string reason;  ///< why it was accepted or not
};

/// What true replicates say of a fitted order (replicates.hpp).
struct ReplicateFit {
  int observations = 0;
  double scatter = not_measured;      ///< of log e within a level, standard deviation
  double half_width = not_measured;   ///< of the 95 % interval of the order, from that scatter or the lack of fit
  double lack_of_fit = not_measured;  ///< probability; small: the level means follow no power law
};

/// Observed order of one series in one norm. The window is declared by the study file, in swept values.
struct ObservedOrder {
  std::string norm;
  double from = 0, to = 0;  ///< declared window
  int points = 0;           ///< usable points inside it
  double order = not_measured;
  double half_width = not_measured;  ///< Student-t 95 % of the slope; NaN under four points
  double constant = not_measured;    ///< C of e = C h^p over the window
  double r_squared = not_measured;
  bool asymptotic = false;  ///< segment orders inside the window agree (fit_order)
  double asymptotic_from = not_measured,
         asymptotic_to = not_measured;  ///< widest asymptotic run of points found; only reported
  std::vector<SegmentOrder> segments;
  std::optional<FloorFit> floor;                ///< when the study asks for it
  std::optional<ReplicateFit> replicates = {};  ///< when the study has some
};

/// The points of one norm of one series: swept value x, step size h, error e.
struct ErrorSample {
  double x = 0;
  double h = 0;
  double e = 0;
};

/// Segment orders that lie within this of each other count as one order. If e = C h^p (1 + c h) with c h <= 1 on the
/// coarsest level and h is halved, three segments that agree to 0.2 leave the finest one within 0.1 of p; scatter of 1
/// % in the errors moves the order of a segment with halved h by 0.03 at most and passes.
inline constexpr double asymptotic_spread = 0.2;

/// The samples with from <= x <= to (to a relative 1e-9) that have a finite positive h and e (an error of exactly 0
/// has no logarithm), in increasing x. Throws UsageError unless from <= to.
std::vector<ErrorSample> usable_samples(std::span<const ErrorSample> samples, double from, double to);

/// The samples with from <= x <= to that have a finite positive h and a finite e of any sign, in increasing x.
std::vector<ErrorSample> samples_within(std::span<const ErrorSample> samples, double from, double to);

/// Fits log e = log C + p log h by least squares over the usable samples of the declared window [from, to]. Needs two
/// of them with different h, else the order is NaN. The 95 % interval is Student's t with n - 2 degrees of freedom, NaN
/// under four points; residuals of a deterministic method are bias and not noise, so it is no test of p.
///
/// The segments join neighbouring usable samples, those outside the window too; between equal h the order is NaN.
/// `asymptotic`: the window holds at least two segments, no sample between them is unusable, and their orders differ
/// by asymptotic_spread at most.
/// `asymptotic_from`, `asymptotic_to`: the longest run of such segments over all samples, of equally long ones the
/// finest; it is only reported. `norm` is left to the caller.
ObservedOrder fit_order(std::span<const ErrorSample> samples, double from, double to);

/// Half-width of the interval of the order that verdicts, goldens and tables take. It is that of the 95 % interval by
/// the replicates where they give one, else by the residuals. Three points leave Student's t only one degree of
/// freedom and get no such interval; half the difference of their two segment orders stands in, so that fewer points do
/// not look more certain. 0 where there is none of these.
double half_width(const ObservedOrder& fit);

/// Whether the window is asymptotic, in a word: "yes" or "no"; "stays" or "grows" where the segment orders agree as in
/// an asymptotic range, but on an order of at most 0.2 or below -0.2: the error does not fall.
std::string asymptotic_word(const ObservedOrder& fit);

/// Highest less lowest order of the segments in the window; 0 with fewer than two segments.
double segment_spread(const ObservedOrder& fit);

/// The order of the finest segment in the window, which is the last or the first; NaN without one.
double finest_segment(const ObservedOrder& fit, bool finest_last);

/// Fits e = C h^p + E0, C and E0 >= 0, 0.1 <= p <= 8, by least squares of the relative misfit over the usable samples
/// of the window; at least six. A sum of two powers fakes a floor (h² + 0.05 h; docs/misprints.md, T10), so it is
/// accepted only when
///   - E0 is at least half of the error at the finest level,
///   - the root mean square of the relative misfit is at most 5 %,
///   - that of the best power law C h^p (any p from -8 to 8) is at least five times as large,
///   - fitted without the finest level it predicts the error there to 10 %,
///   - p lies inside its range.
/// On six to eight levels every sum h^p + a h^q (p, q from 1/2 to 4) tried fails at least one of these, whereas
/// h² + 1e-4 with 1 % scatter misfits by 1 %, a power law by over twenty times that, and it predicts to 3 %.
/// `reason` gives the numbers.
FloorFit fit_floor(std::span<const ErrorSample> samples, double from, double to);

}  // namespace mpmvv::fits
