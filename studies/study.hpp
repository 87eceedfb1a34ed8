#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/case.hpp"
#include "studies/result.hpp"
#include "studies/settings.hpp"
#include "studies/stability_limit.hpp"
#include "studies/window.hpp"

namespace mpmvv {

/// One line of a study's plot: a name and the settings in which it differs from the study's fixed ones.
struct SeriesPlan {
  std::string name;
  std::vector<Setting> settings;  ///< the fixed ones, overwritten by its own
  std::string where;

  /// The setting that counts, the last one of its key; null without one.
  const Setting* setting(const std::string& key) const;
};

/// What to fit: which norm, over which window, for which series; and the window of a fit with a floor, if any.
struct FitPlan {
  std::string norm;
  Window window;
  std::optional<Window> floor;
  std::vector<std::string> series;  ///< empty: all
};

/// Runs that differ in what should not matter, made at each swept value, whose point is their mean; of a limit, each
/// searched.
struct ReplicatePlan {
  std::string key;
  std::vector<double> values;
  std::string where;
};

/// A limit to search, of which series.
struct LimitPlan {
  LimitSearch search;
  std::vector<std::string> series;  ///< empty: all
  std::string where;
};

/// A quantity to extrapolate over the grids of a window, for which series.
struct ExtrapolationPlan {
  std::string norm;
  Window window;
  std::vector<std::string> series;  ///< empty: all
};

/// What a claim asks of the results, as a number with bounds. Committed before the claim's first full run.
struct Criterion {
  enum class Kind {
    order,             ///< fitted order of `series` in `norm` over [from, to]
    order_difference,  ///< the same less the order in `over_norm`
    error,             ///< `norm` of `series` at every swept value in [from, to]
    error_ratio,       ///< the same divided by that of `over`; two unstable runs are equal
    slope_ratio,       ///< slope of `norm` of `series` against the swept value over [from, to], divided by `over`'s
    slope_share,       ///< the same divided by the first value of `over` in [from, to]
    spread,            ///< largest over smallest `norm` of `series` at the swept values in [from, to]
    status,            ///< fraction of `series`' points in [from, to] with status ok
    limit,             ///< stability limit of `series`
    limit_ratio,       ///< the same divided by that of `over`
    cost_ratio,        ///< cost at which `series` reaches each power of ten in [from, to] of `norm`, divided by that
                       ///< of `over`
    value,             ///< value `name` of a check
    shown,             ///< nothing is asked: the figure is the evidence
    awaited            ///< a part of the claim that no study can judge yet: it keeps the claim from being confirmed
  };
  std::string claim;
  std::string statement;
  Kind kind = Kind::shown;
  std::vector<std::string> series;
  std::string over;  ///< series to divide by
  std::string name;  ///< of a check's value
  std::string norm;
  std::string over_norm;  ///< norm to compare the order with
  Window window;
  std::optional<double> at_least, at_most;
  std::string reason;  ///< why it fails, written after the evidence was checked
};

/// A setting that is put on top of every series', or where it may be, of those alone that take it.
struct Overriding {
  Setting setting;
  bool where_taken = false;
};

/// What became of such a setting in a study.
struct Overridden {
  std::size_t series = 0;  ///< that took it
  std::string what;        ///< "shuffle = 3 in 2 of 2 series"
  std::string refusal;     ///< why the last one that was asked does not take it; else empty
};

/// A study as its file describes it.
struct StudyPlan {
  std::string name;  ///< stem of the file
  std::string title;
  std::string text;  ///< the file, whole
  std::vector<std::string> claims;
  std::string check;  ///< for checks: which one; then there are no series
  std::vector<SeriesPlan> series;
  std::string sweep;           ///< swept key; empty without a sweep
  std::vector<double> values;  ///< swept values
  std::string sweep_where;     ///< for messages about a swept value
  std::optional<LimitPlan> limit;
  std::optional<ReplicatePlan> replicates;
  std::vector<FitPlan> fits;
  std::vector<ExtrapolationPlan> extrapolations;
  std::vector<Figure> figures;
  std::vector<Criterion> criteria;
  std::vector<Overridden> overridden;  ///< as the settings were given

  std::string kind() const { return !check.empty() ? "check" : limit ? "limit" : "convergence"; }
  bool has_series(const std::string& name) const;
  bool searches(const SeriesPlan& series) const;  ///< its limit
};

/// Reads and checks a study file: every mistake is a UsageError with file and line, also one in a case that only
/// a combination of series and swept value makes wrong. Series get the `overriding` settings on top of their own;
/// a check has none.
StudyPlan read_study(const std::filesystem::path& file, const std::vector<Overriding>& overriding = {});

/// Whether the runs of a series differ in this key: those of a velocity update without `order` are the same at every
/// one.
bool varies_with(const SeriesPlan& series, const std::string& key);

/// The case of a series at a value of the swept (or searched) key; `where` goes into messages about the value.
Case case_at(const SeriesPlan& series, const std::string& key, double value, const std::string& where);

/// A series by itself, or its replicates.
std::vector<SeriesPlan> replicates_of(const StudyPlan& plan, const SeriesPlan& series);

/// The cases of a series at a swept value: one, or its replicates'.
std::vector<Case> replicates_at(const StudyPlan& plan, const SeriesPlan& series, double value);

/// Judges one criterion by the results.
ClaimPart judge(const Criterion& criterion, const StudyResult& result);

}  // namespace mpmvv
