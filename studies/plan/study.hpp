#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/claims/criterion.hpp"
#include "studies/fits/stability_limit.hpp"
#include "studies/fits/window.hpp"
#include "studies/records/result.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::plan {

/// One line of a study's plot: a name and the settings in which it differs from the study's fixed ones.
struct SeriesPlan {
  std::string name;
  std::vector<settings::Setting> settings;  ///< the fixed ones, overwritten by its own
  std::string where;

  /// The setting that counts, the last one of its key; null without one.
  const settings::Setting* setting(const std::string& key) const;
};

/// What to fit: which norm, over which window, for which series; and the window of a fit with a floor, if any.
struct FitPlan {
  std::string norm;
  fits::Window window;
  std::optional<fits::Window> floor;
  std::vector<std::string> series;  ///< empty: all
};

/// Runs that differ in what should not matter. At each swept value the point of the series is their mean; a limit is
/// searched for each of them.
struct ReplicatePlan {
  std::string key;
  std::vector<double> values;
  std::string where;
};

/// A limit to search, of which series.
struct LimitPlan {
  fits::LimitSearch search;
  std::vector<std::string> series;  ///< empty: all
  std::string where;
};

/// A quantity to extrapolate over the grids of a window, for which series.
struct ExtrapolationPlan {
  std::string norm;
  fits::Window window;
  std::vector<std::string> series;  ///< empty: all
};

/// A setting of `study --set`, which overrides that of every series, or (`--set-where-taken`) of those that take it.
struct Overriding {
  settings::Setting setting;
  bool where_taken = false;
};

/// What an overriding setting changed in a study.
struct Overridden {
  std::size_t series = 0;  ///< that took it
  std::string what;        ///< "shuffle = 3 in 2 of 2 series"
  std::string refusal;     ///< why a check, or the last series that refused it, does not take it; else empty
};

/// What a claim says, and the place in a study file.
struct StatedClaim {
  records::ClaimText text;
  std::string where;
};

/// A study as its file describes it.
struct StudyPlan {
  std::string name;  ///< stem of the file
  std::string title;
  std::string text;                 ///< the file, whole
  std::vector<std::string> claims;  ///< ids of those that it names or states
  std::string claims_where;
  std::vector<StatedClaim> statements;  ///< those that the file states; `state_claims` adds the others that it names
  std::string check;                    ///< for checks: which one; then there are no series
  std::vector<SeriesPlan> series;
  std::string sweep;           ///< swept key; empty without a sweep
  std::vector<double> values;  ///< swept values
  std::string sweep_where;     ///< for messages about a swept value
  std::optional<LimitPlan> limit;
  std::optional<ReplicatePlan> replicates;
  std::vector<FitPlan> fits;
  std::vector<ExtrapolationPlan> extrapolations;
  std::vector<records::Figure> figures;
  std::vector<claims::Criterion> criteria;
  std::vector<Overridden> overridden;  ///< as the settings were given

  records::StudyKind kind() const {
    using records::StudyKind;
    return !check.empty() ? StudyKind::check : limit ? StudyKind::limit : StudyKind::convergence;
  }
  bool has_series(const std::string& name) const;
  bool searches(const SeriesPlan& series) const;  ///< whether its limit is searched
};

/// Reads and checks a study file: every mistake is a UsageError with file and line, also one in a case that only
/// a combination of series and swept value makes wrong. Series get the `overriding` settings on top of their own;
/// a check takes none.
StudyPlan read_study(const std::filesystem::path& file, const std::vector<Overriding>& overriding = {});

/// The same from a text; `file` names the study and its places.
StudyPlan parse_study(const std::string& text, const std::filesystem::path& file,
                      const std::vector<Overriding>& overriding = {});

/// Whether the runs of a series depend on this key. A series whose velocity update has no `order`, for example, gives
/// the same run at every order of a sweep.
bool varies_with(const SeriesPlan& series, const std::string& key);

/// The case of a series at a value of the swept (or searched) key; `where` goes into messages about the value.
cases::Case case_at(const SeriesPlan& series, const std::string& key, double value, const std::string& where);

/// A series by itself, or its replicates.
std::vector<SeriesPlan> replicates_of(const StudyPlan& plan, const SeriesPlan& series);

/// The cases of a series at a swept value: one, or its replicates'.
std::vector<cases::Case> replicates_at(const StudyPlan& plan, const SeriesPlan& series, double value);

}  // namespace mpmvv::plan
