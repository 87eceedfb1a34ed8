#include "reports/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/outputs.hpp"
#include "cli/results.hpp"
#include "cli/shipped.hpp"
#include "goldens/gate.hpp"
#include "studies/claims/claim.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

struct ReportOptions {
  std::string db, out, goldens;
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
  return reports::read_mutation_results(published / "summary.json");
}

/// The first report of a study comes before its first golden.
bool has_goldens(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return false;
  if (!std::filesystem::is_directory(folder)) return true;
  const std::filesystem::directory_iterator files(folder), end;
  return std::any_of(files, end, [](const auto& entry) { return entry.path().extension() == ".toml"; });
}

int report(const ReportOptions& options) {
  reports::ReportInput input;
  input.provenance = store::current_provenance();
  input.studies = own_results(options.db);
  const std::filesystem::path folder = goldens_for(input.studies, options.goldens);
  require_apart("--out", options.out, {options.db, folder, published});
  if (input.studies.empty())
    throw support::UsageError(fmt::format("{} holds no study of this program (run `mpmvv study` first)", options.db));
  if (has_goldens(folder))
    for (const goldens::GateResult& r : goldens::run_gate(goldens::read_goldens(folder), input.studies).results)
      input.gate.push_back({r.study + ": " + r.name, to_string(r.verdict), r.expected, r.measured, r.reason});
  const store::Store store(options.db, store::Store::Mode::read);
  auto mutation = own_mutation(options.db);
  for (const claims::Claim& claim : judged_claims(input.studies, mutation))
    input.claims.push_back({claim.id, claim.verdict, claim.verdict == "open" ? claim.statement : claim.evidence});
  input.mutation = shown_mutation(options.db, std::move(mutation));
  input.alarms = own_alarms();
  input.versions = store.versions();
  if (reports::has_trends(input)) input.trends = trends_in(store, input.versions);
  input.benchmark = own_benchmark(options.db, input.provenance.digest);
  const bool terminal = isatty(STDERR_FILENO);
  const reports::ReportSummary summary = reports::write_report(input, options.out, [terminal](const std::string& what) {
    if (terminal) note("{}\n", what);
  });
  print("{}/index.html: {} figures ({} drawn), {} tables ({} written)\n", options.out, summary.figures,
        summary.figures_drawn, summary.tables, summary.tables_written);
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
  add_examples(*command, {"mpmvv report --db results.db --out report"});
  command->callback([options, &exit_code] { exit_code = report(*options); });
}

}  // namespace mpmvv::cli
