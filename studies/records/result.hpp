#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/fits/extrapolation.hpp"
#include "studies/fits/observed_order.hpp"
#include "studies/fits/stability_limit.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::records {

/// One point of a series: a run at one value of the swept key, or a point of a curve made by a check.
struct Point {
  double x = 0;  ///< swept value
  Status status = Status::ok;
  std::string reason;
  std::map<std::string, double>
      y;  ///< by quantity: `l1`, `l2`, `linf`, `..._all_steps`, `wall_seconds`, ...; curves: `y`
  std::map<std::string, std::vector<double>> replicates = {};  ///< by quantity, where `y` is their mean
  std::vector<ParticleError> particle_errors = {};             ///< of a run that was asked for them
  fits::Rounds rounds = {};                                    ///< of a run whose cost was measured
};

/// The code, other than our own solver, that ran a series.
struct OtherCode {
  std::string name, version;
  std::string variant;  ///< empty when the code has only one
  std::string force_form;
  std::string digest = {};  ///< of its adapter and its program's file; empty in a study that was read from a store
};

struct Series {
  std::string name;
  std::vector<Point> points;  ///< in the order of the sweep
  std::vector<fits::ObservedOrder> orders;
  std::optional<fits::StabilityLimit> limit;
  std::vector<fits::Extrapolation> extrapolations = {};
  std::optional<OtherCode> code = {};  ///< the code that ran it; none for our own solver and for checks
};

/// A named number measured by a check.
struct Value {
  std::string name;
  double value = support::not_measured;
  std::string meaning;  ///< one line for people
};

/// A report's figure, as the study file describes it. `kind` says what is drawn: `curves` is the quantity of each
/// series against the swept value; `work-precision` is the quantity against the measured cost; `particles` is a panel
/// for each series. A panel of a check shows its points as particles at (x, `y`), with voxels of widths `width_x`,
/// `width_y` where they have any. A panel of runs shows the particles of the last sound run, coloured by their errors.
struct Figure {
  enum class Kind { curves, work_precision, particles };

  std::string name;  ///< file name without ending, `s-fig10`
  std::string caption;
  std::string xlabel, ylabel;
  bool log_x = true, log_y = true;
  std::string quantity = "l2";      ///< which `y` of the points
  std::vector<std::string> series;  ///< names; empty: all
  std::vector<std::string> marks;   ///< series drawn as separate points, without a line
  std::vector<double> slopes;       ///< reference slopes to draw, in powers of h
  std::optional<double> x_min, x_max, y_min, y_max;
  Kind kind = Kind::curves;
};
constexpr std::array<const char*, 3> words_of(Figure::Kind) {
  return {"curves", "work-precision", "particles"};
}

enum class PartVerdict { holds, fails, shown, inconclusive };
constexpr std::array<const char*, 4> words_of(PartVerdict) {
  return {"holds", "fails", "shown", "inconclusive"};
}

/// A claim as a study file states it.
struct ClaimText {
  std::string id;
  std::string statement;
  std::string source;  ///< "Steffen et al. 2008"; may be empty
  std::string where;   ///< the place in it, "Fig. 10"; may be empty
  std::string study;   ///< the study that states it; other studies may name it
};

/// A number that a criterion compared. `what` names the series and, where there is one, the point.
struct Found {
  std::string what;
  double value = support::not_measured;
  double lower = value, upper = value;  ///< where it may lie; the value alone where no uncertainty is known
  std::string remark = {};              ///< "finest segment 1.42"; without "; ", which parts numbers of the evidence
};

/// One criterion of a claim, judged.
struct ClaimPart {
  std::string claim;
  std::string statement;  ///< what was asked
  PartVerdict verdict = PartVerdict::inconclusive;
  std::string evidence;      ///< measured numbers
  std::string reason;        ///< for `fails`: why, as the study file explains it after the fact; may be empty
  std::string measure = {};  ///< the criterion's word, "order"; empty where no criterion of a study was judged
  std::optional<double> at_least = {}, at_most = {};
  std::vector<Found> found = {};  ///< in the order of the evidence
  std::string withheld = {};      ///< why it is inconclusive whatever was found; may be empty

  bool is_order() const { return measure.starts_with("order"); }
  bool is_limit() const { return measure.starts_with("limit"); }
};

inline bool is_of_another_code(const Series& series) {
  return series.code.has_value();
}

/// Whether the part names one of the series in quotes: in its evidence, or, where nothing could be measured, in what
/// was asked.
bool speaks_of(const ClaimPart& part, const std::vector<Series>& series);

enum class StudyKind { convergence, limit, check };
constexpr std::array<const char*, 3> words_of(StudyKind) {
  return {"convergence", "limit", "check"};
}

/// Everything the store keeps of one study, ready to be judged and drawn.
struct StudyResult {
  std::string name;  ///< stem of the study file
  std::string title;
  StudyKind kind = StudyKind::convergence;
  std::string sweep;  ///< swept key: `cells` (then h = 1/x), `cfl`, ...; for checks the name of the abscissa
  std::string text;   ///< the study file, whole
  std::vector<std::string> claims;  ///< ids of the claims that it judges
  std::vector<Series> series;
  std::vector<Value> values;
  std::vector<Figure> figures;
  std::vector<ClaimPart> parts;
  std::vector<ClaimText> statements = {};  ///< of its claims, as far as they are known
};

}  // namespace mpmvv::records
