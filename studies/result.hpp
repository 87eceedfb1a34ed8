#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/record.hpp"

namespace mpmvv {

/// Order between two neighbouring points.
struct SegmentOrder {
  double from = 0, to = 0;  ///< swept values
  double order = 0;
};

/// e = C h^p + E0, NUMERICS.md; `accepted` only by its own test. The values stand even when it is rejected.
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
  double half_width = not_measured;   ///< 95 % of the order, from that scatter
  double lack_of_fit = not_measured;  ///< probability; small: the power law is no law of the means
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
  bool asymptotic = false;  ///< segment orders inside the window agree (observed_order.hpp)
  double asymptotic_from = not_measured,
         asymptotic_to = not_measured;  ///< widest asymptotic run of points found; only reported
  std::vector<SegmentOrder> segments;
  std::optional<FloorFit> floor;                ///< when the study asks for it
  std::optional<ReplicateFit> replicates = {};  ///< when the study has some
};

/// A quantity without an exact value, extrapolated over the grids of a window (extrapolation.hpp).
struct Extrapolation {
  std::string norm;  ///< the quantity
  double from = 0, to = 0;
  int points = 0;
  std::string model;                        ///< the form taken, or why there is none
  double order = not_measured;              ///< p that the free fit finds
  double limit = not_measured;              ///< φ0
  double deviation = not_measured;          ///< σ
  double finest = not_measured;             ///< φ of the finest grid
  double uncertainty = not_measured;        ///< U of that, 95 %
  double convergence_index = not_measured;  ///< Roache's GCI of that, absolute
  std::string remark = {};                  ///< why there is no GCI, what p is worth; else empty
};

/// One point of a series: a run at one value of the swept key, or a point of a curve made by a check.
struct Point {
  double x = 0;  ///< swept value
  Status status = Status::ok;
  std::string reason;
  std::map<std::string, double>
      y;  ///< by quantity: `l1`, `l2`, `linf`, `..._all_steps`, `wall_seconds`, ...; curves: `y`
  std::map<std::string, std::vector<double>> replicates = {};  ///< by quantity, where `y` is their mean
};

/// One probe of a limit search.
struct Probe {
  double value = 0;
  bool stable = false;
  std::string reason;
};

/// Stability limit by scan and bisection: the true limit lies between `stable` and `unstable`.
struct StabilityLimit {
  std::string key;                 ///< what was varied: `cfl`, `smoothing_length`
  double stable = not_measured;    ///< last stable value next to the limit
  double unstable = not_measured;  ///< first unstable value next to it
  bool monotone = true;            ///< false: a stable probe lies beyond an unstable one
  bool found = false;              ///< false: nothing unstable, or the stable end itself unstable
  std::vector<Probe> probes;       ///< in increasing value

  double value() const { return (stable + unstable) / 2; }
};

struct Series {
  std::string name;
  std::vector<Point> points;  ///< in the order of the sweep
  std::vector<ObservedOrder> orders;
  std::optional<StabilityLimit> limit;
  std::vector<Extrapolation> extrapolations = {};
};

/// A named number measured by a check.
struct Value {
  std::string name;
  double value = not_measured;
  std::string meaning;  ///< one line for people
};

/// A report's figure, as the study file describes it. Its kind says what is drawn: `curves`, the quantity of each
/// series against the swept value; `work-precision`, the quantity against the measured cost; `particles`, a panel for
/// each series, whose points are particles at (x, `y`) with voxels of widths `width_x`, `width_y` where they have any.
struct Figure {
  std::string name;  ///< file name without ending, `s-fig10`
  std::string caption;
  std::string xlabel, ylabel;
  bool log_x = true, log_y = true;
  std::string quantity = "l2";      ///< which `y` of the points
  std::vector<std::string> series;  ///< names; empty: all
  std::vector<std::string> marks;   ///< series drawn as separate points, without a line
  std::vector<double> slopes;       ///< reference slopes to draw, in powers of h
  std::optional<double> x_min, x_max, y_min, y_max;
  std::string kind = "curves";
};

enum class PartVerdict { holds, fails, shown, inconclusive };

std::string to_string(PartVerdict v);
PartVerdict part_verdict_from(const std::string& word);

/// One criterion of a claim, judged.
struct ClaimPart {
  std::string claim;      ///< id in CLAIMS.md
  std::string statement;  ///< what was asked
  PartVerdict verdict = PartVerdict::inconclusive;
  std::string evidence;  ///< measured numbers
  std::string reason;    ///< for `fails`: why, as the study file explains it after the fact; may be empty
};

/// Everything the store keeps of one study, ready to be judged and drawn.
struct StudyResult {
  std::string name;  ///< stem of the study file
  std::string title;
  std::string kind;   ///< `convergence`, `limit`, `check`
  std::string sweep;  ///< swept key: `cells` (then h = 1/x), `cfl`, ...; for checks the name of the abscissa
  std::string text;   ///< the study file, whole
  std::vector<std::string> claims;
  std::vector<Series> series;
  std::vector<Value> values;
  std::vector<Figure> figures;
  std::vector<ClaimPart> parts;
};

}  // namespace mpmvv
