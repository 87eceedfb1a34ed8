#include "reports/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "cli/case_commands.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/earlier.hpp"
#include "cli/help.hpp"
#include "cli/max_age.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "cli/results.hpp"
#include "cli/shipped.hpp"
#include "goldens/gate.hpp"
#include "studies/claims/claim.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cli {

namespace {

struct ReportOptions {
  std::string db, out, goldens;
  std::optional<int> max_age;  // h
};

/// What `./run benchmark` left beside the store, unless it measured another program.
std::optional<reports::Benchmark> own_benchmark(const std::string& db, const std::string& digest) {
  const auto file = std::filesystem::path(db).parent_path() / "benchmark.json";
  auto benchmark = reports::read_benchmark(file);
  if (!benchmark || benchmark->digest == digest) return benchmark;
  note("{} measured another build of the program: left out (`./run benchmark` makes it anew)\n", file.string());
  return std::nullopt;
}

/// This program's mutants or, for a build that has none of its own, the published ones, which decide no claim.
std::optional<reports::MutationResults> shown_mutation(const std::string& db,
                                                       std::optional<reports::MutationResults> own) {
  if (own) return own;
  if (reports::read_mutation_results(mutants_beside(db)))
    note("{} tried another build of the program: left out (`./run mutants` makes it anew)\n",
         mutants_beside(db).string());
  return reports::read_mutation_results(published("summary.json"));
}

void add_gate_lines(reports::ReportInput& input, const std::vector<goldens::Golden>& goldens,
                    const std::map<std::string, std::string>& outdated) {
  if (goldens.empty()) return;
  for (const goldens::GateResult& r : goldens::run_gate(goldens, input.studies, {.outdated = outdated}).results)
    input.gate.push_back({r.study, r.name, r.verdict, r.expected, r.measured, r.reason});
}

/// Which series of the studies other codes ran. They are those of the studies as they were read: the store may have
/// others by now, where a study is being kept at the same time.
std::vector<store::CodeSeries> code_series_of(const reports::ReportInput& input) {
  std::vector<store::CodeSeries> codes;
  for (const records::StudyResult& study : input.studies)
    for (const records::Series& series : study.series)
      if (series.code && input.provenances.contains(study.name))
        codes.push_back({study.name, series.name, *series.code, input.provenances.at(study.name).time});
  return codes;
}

/// The history of the program and of each other code, where the store has at least two versions: a trend needs two.
std::vector<reports::History> histories_in(const store::Store& store) {
  std::vector<std::string> codes = store.codes();
  codes.insert(codes.begin(), "");
  std::vector<reports::History> histories;
  for (const std::string& code : codes)
    if (const auto versions = versions_in(store, code); versions.size() >= 2) {
      reports::History& history = histories.emplace_back(code, versions, trends_in(store, code, versions));
      if (code.empty()) continue;
      const auto comparison =
          goldens::compare(findings_in(store, code, *(versions.end() - 2)), findings_in(store, code, versions.back()));
      history.newest = changes_of(comparison);
      history.newest.gone = comparison.only_before;
    }
  return histories;
}

/// All that the store and what lies beside it say of this program.
reports::ReportInput report_input(const ReportOptions& options) {
  reports::ReportInput input;
  const store::Provenance own = store::current_provenance();
  input.digest = own.digest, input.written = own.time;
  input.studies = own_results(options.db);
  const std::filesystem::path folder = goldens_for(input.studies, options.goldens);
  require_apart("--out", options.out, {options.db, folder, shipped("tests/mutation")});
  require_own_results(input.studies, options.db);
  const auto goldens = goldens_in(folder, options.goldens);
  const store::Store store(options.db, store::Store::Mode::read);
  add_gate_lines(input, goldens, outdated(input.studies, store, options.max_age));
  auto mutation = own_mutation(options.db);
  input.claims = judged_claims(input.studies, mutation);
  input.mutation = shown_mutation(options.db, std::move(mutation));
  input.alarms = own_alarms();
  input.histories = histories_in(store);
  input.earlier = earlier_version(store, goldens, input.studies);
  input.provenances = provenances_of(input.studies, store);
  input.codes = code_series_of(input);
  for (const records::StudyResult& study : input.studies) {
    input.dimensions[study.name] = dimension_of(study);
    if (auto commands = case_commands(study); !commands.empty()) input.commands[study.name] = std::move(commands);
    input.calls[study.name] = study_call(study);
  }
  input.benchmark = own_benchmark(options.db, input.digest);
  return input;
}

int report(const ReportOptions& options) {
  const reports::ReportInput input = report_input(options);
  const bool terminal = isatty(STDERR_FILENO);
  const reports::ReportSummary summary = reports::write_report(input, options.out, [terminal](const std::string& what) {
    if (terminal) note("{}\n", what);
  });
  print("{}/index.html: {} ({} drawn), {} ({} written)\n", options.out,
        count_text(static_cast<std::size_t>(summary.figures), "figure"), summary.figures_drawn,
        count_text(static_cast<std::size_t>(summary.tables), "table"), summary.tables_written);
  return 0;
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Write the HTML report, its figures and tables");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_option("--out", options->out, "folder of the report")->required()->type_name("FOLDER");
  command
      ->add_option("--goldens", options->goldens,
                   fmt::format("folder of goldens, judged in the report ({})", default_goldens))
      ->type_name("FOLDER");
  add_max_age(*command, options->max_age);
  add_examples(*command, {"mpmvv report --db results.db --out report"});
  command->callback([options, &exit_code] { exit_code = report(*options); });
}

}  // namespace mpmvv::cli
