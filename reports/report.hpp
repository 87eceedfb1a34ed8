#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reports/alarm_counts.hpp"
#include "reports/benchmark.hpp"
#include "reports/mutation_results.hpp"
#include "reports/origin.hpp"
#include "reports/study_call.hpp"
#include "studies/claims/claim.hpp"
#include "studies/claims/trend.hpp"
#include "studies/records/result.hpp"
#include "studies/records/verdict.hpp"
#include "studies/store/code_series.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::reports {

/// One expectation of the goldens, judged.
struct GateLine {
  std::string study;
  std::string name;
  records::Verdict verdict = records::Verdict::inconclusive;
  std::string expected;
  std::string measured;
  std::string reason;  ///< may be empty
};

/// What changed from one version to the next.
struct Changes {
  std::size_t compared = 0;         ///< results of both versions
  std::vector<std::string> differ;  ///< those of them that differ, worst first
  std::vector<std::string> gone;    ///< results that only the first has
};

/// What the store's version before this one says.
struct Earlier {
  using VerdictStep = std::pair<records::Verdict, records::Verdict>;  ///< then, now

  std::string label;                                     ///< of the version
  std::size_t goldens_compared = 0;                      ///< those whose study both versions have; no trials
  std::map<VerdictStep, int> gate_change;                ///< how many of them have another verdict now
  std::map<std::string, claims::Claim::Verdict> claims;  ///< by id, of claims that the same studies judge now
  Changes changes;                                       ///< since then
  std::vector<double> cost_ratios;                       ///< now over then, of each timed series
};

/// How to repeat the runs of a series: those of its sweep, or those of the search of its limit.
struct SeriesCommand {
  std::string series;
  std::string text;       ///< of a shell, with {} for the swept or probed value
  std::string note;       ///< what it is of, and what it leaves out; may be empty
  bool is_probe = false;  ///< of the search of the limit
};

/// The versions in a store, and how results changed over them.
struct History {
  std::string code;                      ///< empty: our own program
  std::vector<store::Version> versions;  ///< by time
  std::vector<claims::Trend> trends;     ///< over these versions
  Changes newest = {};                   ///< of another code: what its newest version changed
};

struct ReportInput {
  std::vector<records::StudyResult> studies;
  std::vector<GateLine> gate;
  std::vector<claims::Claim> claims;
  std::string digest;       ///< of the program
  std::string written;      ///< when, ISO 8601, UTC
  Provenances provenances;  ///< of the studies
  std::optional<Benchmark> benchmark = {};
  std::vector<History> histories = {};  ///< of our own program and of other codes, where there are two versions
  std::optional<MutationResults> mutation = {};
  std::vector<AlarmCount> alarms = {};  ///< of the quick gate on programs without a mistake
  std::optional<Earlier> earlier = {};
  std::vector<store::CodeSeries> codes = {};                        ///< series that other codes ran
  std::map<std::string, std::vector<SeriesCommand>> commands = {};  ///< by study
  std::map<std::string, int> dimensions = {};                       ///< of the bodies, by study; 0 where they differ
  std::map<std::string, StudyCall> calls = {};  ///< by study; a study without one is called by its file, STUDY.toml
};

/// What a call wrote: files whose content is already right are left alone.
struct ReportSummary {
  int figures = 0, figures_drawn = 0;
  int tables = 0, tables_written = 0;
  std::set<std::filesystem::path> files = {};  ///< that make the report, relative to its folder
};

/// Writes OUT/index.html and what it leads to: gate.html, a page for each study in OUT/studies/ and for each claim in
/// OUT/claims/, and where there is something to show benchmark.html, codes.html, mutants.html and trend.html;
/// OUT/figures/ NAME.{gp,dat,svg,pdf} (STUDY~NAME where studies share the name), OUT/trends/NAME.*,
/// OUT/points/NAME.js, OUT/tables/STUDY.csv, STUDY.tex and, where there are any, WHAT/STUDY.csv, program/benchmark.tex,
/// program/codes.tex and program/mutants.tex, and style.css, report.js and .report-files. Nothing comes from outside
/// OUT, and only links to the sources of published costs lead there. What an earlier report wrote in OUT and this one
/// does not is removed. Throws UsageError, and leaves OUT as it was, when a file cannot be written, is no report's, or
/// gnuplot is missing or fails.
ReportSummary write_report(const ReportInput& input, const std::filesystem::path& out_dir,
                           const std::function<void(const std::string&)>& progress);

}  // namespace mpmvv::reports
