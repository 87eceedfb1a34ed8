#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/alarm_log.hpp"
#include "reports/benchmark.hpp"
#include "reports/mutation_results.hpp"
#include "studies/claims/trend.hpp"
#include "studies/records/result.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::reports {

/// One expectation of the goldens, judged.
struct GateLine {
  std::string name;
  std::string verdict;  ///< `pass`, `fail`, `inconclusive`
  std::string expected;
  std::string measured;
  std::string reason;  ///< may be empty
};

/// One claim of docs/claims.md, judged.
struct ClaimLine {
  std::string id;
  std::string verdict;  ///< `confirmed`, `refuted`, `partly`, `shown`, `open`
  std::string evidence;
};

struct ReportInput {
  std::vector<records::StudyResult> studies;
  std::vector<GateLine> gate;
  std::vector<ClaimLine> claims;
  store::Provenance provenance;
  std::optional<Benchmark> benchmark = {};
  std::vector<store::Version> versions = {};  ///< all of the store, by time
  std::vector<claims::Trend> trends = {};     ///< over these versions
  std::optional<MutationResults> mutation = {};
  std::vector<AlarmRun> alarms = {};  ///< runs of the gate without a mistake
};

/// Whether there are trends to draw: it takes two versions.
inline bool has_trends(const ReportInput& input) {
  return input.versions.size() >= 2;
}

/// What a call wrote: files whose content is already right are left alone.
struct ReportSummary {
  int figures = 0, figures_drawn = 0;
  int tables = 0, tables_written = 0;
};

/// Writes OUT/index.html (one page, nothing outside it), OUT/figures/NAME.{gp,dat,svg,pdf} (STUDY~NAME where studies
/// share the name), OUT/tables/STUDY.csv, STUDY.tex and, where there are any, WHAT/STUDY.csv, program/benchmark.tex and
/// program/mutants.tex; with trends OUT/trend.html and OUT/trends/NAME.* too. Throws UsageError, and leaves OUT as it
/// was, when a file cannot be written or gnuplot is missing or fails.
ReportSummary write_report(const ReportInput& input, const std::filesystem::path& out_dir,
                           const std::function<void(const std::string&)>& progress);

}  // namespace mpmvv::reports
