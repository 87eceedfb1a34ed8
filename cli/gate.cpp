#include "goldens/gate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/gate_text.hpp"
#include "cli/help.hpp"
#include "cli/max_age.hpp"
#include "cli/outputs.hpp"
#include "cli/planted_series.hpp"
#include "cli/results.hpp"
#include "cli/shipped.hpp"
#include "goldens/github.hpp"
#include "goldens/junit.hpp"
#include "goldens/propose.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cli {

using goldens::Verdict;

namespace {

struct GateOptions {
  std::string db, goldens, junit;
  std::vector<std::string> only;
  std::optional<int> max_age;  // h
  bool json = false, github = false, as_set = false, verbose = false;
};

/// GitHub Actions sets this in every step.
bool in_github_actions() {
  const char* word = std::getenv("GITHUB_ACTIONS");
  return word != nullptr && std::string(word) == "true";
}

/// Makes the folder in which a new file will lie.
void make_folder_of(const std::filesystem::path& file) {
  if (file.has_parent_path()) support::make_folder(file.parent_path());
}

nlohmann::json gate_json(const goldens::GateReport& report, const GatedCodes& gated) {
  nlohmann::json codes = nlohmann::json::array();
  for (const auto& [ran, shares_version] : gated.judged)
    codes.push_back({{"study", ran.study},
                     {"code", ran.code.name},
                     {"version", ran.code.version},
                     {"digest", ran.code.digest},
                     {"time", ran.kept_at}});
  nlohmann::json results = nlohmann::json::array();
  for (const goldens::GateResult& r : report.results)
    results.push_back({{"study", r.study},
                       {"name", r.name},
                       {"verdict", to_string(r.verdict)},
                       {"expected", r.expected},
                       {"measured", r.measured.empty() ? nlohmann::json() : nlohmann::json(r.measured)},
                       {"reason", r.reason},
                       {"where", r.where},
                       {"better", r.better},
                       {"absent", r.is_absent}});
  return {{"pass", report.count(Verdict::pass)},
          {"fail", report.count(Verdict::fail)},
          {"inconclusive", report.count(Verdict::inconclusive)},
          {"codes", codes},
          {"results", results}};
}

/// Notes which study files are not what was run: goldens are held against what was run.
void note_others(const std::vector<records::StudyResult>& results, const std::vector<std::string>& only) {
  for (const records::StudyResult& study : results)
    if (const auto file = other_file(study);
        !file.empty() && (only.empty() || std::ranges::count(only, study.name) > 0))
      note("{}: {} is not what was run (`mpmvv study` runs what is new)\n", study.name, file.string());
}

/// Whether the store has several programs that say this version of themselves. It counts no trials.
bool shares_version(const store::Store& store, const records::OtherCode& code) {
  const auto codes = store.codes();
  if (std::ranges::find(codes, code.name) == codes.end()) return false;
  return std::ranges::count_if(store.versions_of_code(code.name), [&](const store::Version& version) {
           return version.commits.front() == code.version;
         }) > 1;
}

/// The versions of other codes that ran the studies whose goldens are judged, and the studies without.
GatedCodes gated_codes(const GateOptions& options, const goldens::GateReport& report) {
  const store::Store store(options.db, store::Store::Mode::read);
  std::set<std::string> with_goldens;
  for (const goldens::GateResult& r : report.results) with_goldens.insert(r.study);
  GatedCodes codes;
  std::set<std::pair<std::string, std::string>> seen;
  std::set<std::string> without;
  for (const store::CodeSeries& s : store.code_series(store::current_provenance().digest)) {
    if (!with_goldens.contains(s.study))
      without.insert(s.study);
    else if (seen.emplace(s.study, s.code.name).second)
      codes.judged.push_back({s, shares_version(store, s.code)});
  }
  if (options.only.empty()) codes.without_golden = {without.begin(), without.end()};
  return codes;
}

int gate(const GateOptions& options) {
  const auto results = own_results(options.db);
  note_others(results, options.only);
  const std::filesystem::path folder = goldens_for(results, options.goldens);
  require_apart("--junit", options.junit, {options.db, folder});
  for (const records::StudyResult& study : results) require_apart("--junit", options.junit, files_named_as(study));
  const goldens::GateReport report =
      goldens::run_gate(goldens::read_goldens(folder), results,
                        {.only = options.only,
                         .trials = options.as_set ? goldens::Trials::judged : goldens::Trials::inconclusive,
                         .outdated = outdated(results, {options.db, store::Store::Mode::read}, options.max_age)});
  if (!options.junit.empty()) write_output("--junit", options.junit, goldens::junit_xml(report));
  if (options.json)
    print_json(gate_json(report, gated_codes(options, report)));
  else
    print_gate(report, gated_codes(options, report), options.verbose);
  if (options.github || (in_github_actions() && !options.json)) print_text(goldens::github_annotations(report));
  return report.exit_code();
}

struct ProposeOptions {
  std::string db, study, out, goldens;
};

/// Whether the new file is the first one in a folder of goldens that is not there yet.
bool begins_folder(const ProposeOptions& options) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  if (options.goldens.empty() || options.out.empty() || fs::exists(options.goldens, unknown)) return false;
  const fs::path out = fs::absolute(options.out), inside = fs::absolute(options.goldens) / out.filename();
  return fs::weakly_canonical(out, unknown) == fs::weakly_canonical(inside, unknown);
}

std::vector<goldens::Golden> standing_goldens(const ProposeOptions& options, const records::StudyResult& study) {
  if (begins_folder(options)) return {};
  const std::filesystem::path folder = goldens_for({study}, options.goldens);
  return goldens::has_goldens(folder) ? goldens::read_goldens(folder) : std::vector<goldens::Golden>{};
}

int propose(const ProposeOptions& options) {
  const auto results = own_results(options.db);
  const auto study =
      std::find_if(results.begin(), results.end(), [&](const auto& s) { return s.name == options.study; });
  if (study == results.end())
    throw support::UsageError(
        fmt::format("no results of study '{}' in {} (run `mpmvv study` on it first)", options.study, options.db));
  const auto provenance = store::Store(options.db, store::Store::Mode::read)
                              .study_provenance(study->name, store::current_provenance().digest);
  if (is_shipped(*study)) goldens::require_committed(*study, *provenance);
  const std::set<std::string> planted = planted_series(*study);
  const std::string text = goldens::propose_goldens(*study, *provenance, standing_goldens(options, *study), planted);
  if (!planted.empty()) note("no golden of planted mistakes: {}\n", fmt::format("'{}'", fmt::join(planted, "', '")));
  if (options.out.empty()) {
    print_text(text);
    return 0;
  }
  if (std::filesystem::exists(std::filesystem::symlink_status(options.out)))
    throw support::UsageError(fmt::format("{} exists (name a new file, review, then move it)", options.out));
  make_folder_of(options.out);
  support::write_if_changed(options.out, text);
  return 0;
}

}  // namespace

void add_gate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<GateOptions>();
  CLI::App* command = app.add_subcommand("gate", "Hold the store's results against the goldens");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_option("--goldens", options->goldens, fmt::format("folder of goldens ({})", default_goldens))
      ->type_name("FOLDER");
  command->add_option("--only", options->only, "judge only this study's goldens (repeatable)")->type_name("STUDY");
  command->add_option("--junit", options->junit, "write JUnit XML to this file, too")->type_name("FILE");
  add_max_age(*command, options->max_age);
  command->add_flag("--as-set", options->as_set,
                    "judge results made with study --set, too (default: they are inconclusive)");
  command->add_flag("--verbose", options->verbose, "print what passes, too, and each golden without a result");
  CLI::Option* json = command->add_flag("--json", options->json, "print one JSON object");
  command->add_flag("--github", options->github, "print annotations for GitHub Actions, too (default: when run by it)")
      ->excludes(json);
  add_examples(*command, {"mpmvv gate --db results.db", "mpmvv gate --db results.db --only splines --verbose",
                          "mpmvv gate --db results.db --junit gate.xml"});
  command->callback([options, &exit_code] { exit_code = gate(*options); });
}

void add_propose(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ProposeOptions>();
  CLI::App* command = app.add_subcommand("propose", "Write goldens for review from the store's results of a study");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_option("--study", options->study, "name of the study")->required()->type_name("STUDY");
  command
      ->add_option("--goldens", options->goldens, fmt::format("folder of the goldens that stand ({})", default_goldens))
      ->type_name("FOLDER");
  command->add_option("--out", options->out, "a file that does not exist yet (default: standard output)")
      ->type_name("FILE");
  add_examples(*command, {"mpmvv propose --db results.db --study splines --out new-splines.toml"});
  command->callback([options, &exit_code] { exit_code = propose(*options); });
}

}  // namespace mpmvv::cli
