#include "studies/codes/score.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/record_json.hpp"
#include "cli/run_text.hpp"
#include "cli/shipped.hpp"
#include "studies/cases/setting.hpp"
#include "studies/codes/case_file.hpp"
#include "studies/codes/readers.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/problems/problem.hpp"
#include "studies/store/store.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

struct ScoreOptions {
  std::string the_case;
  std::vector<std::string> outputs, start;
  std::string format, columns, step, length, time, mass, thickness, db;
  bool json = false;
};

/// The adapter of the case's code; none where the case is of no other code, or its adapter is not here.
std::optional<codes::Adapter> adapter_of(const cases::Case& c) {
  const std::string& code = c.scheme.code;
  if (code.empty()) return std::nullopt;
  for (const std::filesystem::path& file : plan::CodeFinder(shipped("adapters")).adapter_files())
    if (file.parent_path().filename() == code) try {
        codes::Adapter adapter = codes::read_adapter(file);
        note("columns and units are those of {}, unless an option says another\n", file.string());
        return adapter;
      } catch (const UsageError& e) {
        note("columns and units are not those of the code's adapter: {}\n", e.what());
      }
  return std::nullopt;
}

/// The word of the option; without it the ending of the first file says the format, else the adapter.
std::string format_of(const ScoreOptions& options, const codes::OutputFiles& usual) {
  const std::string extension = std::filesystem::path(options.outputs.front()).extension();
  const bool is_known = std::ranges::any_of(codes::formats(), [&extension](const codes::Format& format) {
    return std::ranges::find(format.endings, extension) != format.endings.end();
  });
  return options.format.empty() && !is_known ? usual.format : options.format;
}

/// Reads the file's columns by what options say, else by what the adapter says.
codes::Columns columns_in(const ScoreOptions& options, const cases::Case& c, codes::Columns columns) {
  columns.dimensions = problems::domain_cells(c).size();
  if (!options.columns.empty()) {
    columns.names = codes::parse_columns(options.columns, "--columns");
    columns.where = "--columns";
  }
  const auto read = [](const std::string& text, const char* what, const char* option, double& value) {
    if (!text.empty()) value = cases::positive({what, text, option});
  };
  read(options.length, "length unit", "--length-unit", columns.length);
  read(options.time, "time unit", "--time-unit", columns.time);
  read(options.mass, "mass unit", "--mass-unit", columns.mass);
  if (!options.thickness.empty() && columns.dimensions != 2)
    throw UsageError(fmt::format("--thickness {} of a case in {} dimension{} (it is that of a plane body)",
                                 options.thickness, columns.dimensions, columns.dimensions == 1 ? "" : "s"));
  read(options.thickness, "thickness", "--thickness", columns.thickness);
  if (!options.step.empty()) columns.step = cases::whole({"step", options.step, "--step"}, 0, 1'000'000'000'000);
  return columns;
}

/// Throws unless a study may ask for the case: it must be of another code, with its version and adapter, and its cost
/// must not be measured.
void require_keepable(const cases::Case& c, const std::string& file) {
  if (c.scheme.adapter.empty())
    throw UsageError(
        fmt::format("--db with {}, which names no version of another code (mpmvv case --code NAME ..., where the code "
                    "and its adapter are)",
                    file));
  if (c.measure.repeat > 0)
    throw UsageError(fmt::format("--db with {}, whose cost is measured (a case without repeat)", file));
}

/// Puts the record where a study finds it in place of a run, unless there is one.
void keep(const records::Record& record, const std::string& db) {
  store::Store store(db, store::Store::Mode::create_or_write);
  const store::Provenance provenance = store::current_provenance();
  const auto known = store.find(record.the_case, provenance.digest);
  if (known && !records::is_worth_another_try(*known))
    throw UsageError(
        fmt::format("{} holds this case already (a store of its own, or another version of the code)", db));
  store.keep(record, provenance);
}

/// Says which errors the case asks for and the output does not give.
void note_missing_errors(const records::Record& record, const std::string& files) {
  const auto note_without = [&files](const char* error, const char* what) {
    note("mpmvv: no {} error: {} has no {}, or some that are no numbers\n", error, files, what);
  };
  const cases::Measure& asked = record.the_case.measure;
  if (asked.velocity_error && std::isnan(record.error.velocity)) note_without("velocity", "velocities");
  if (asked.stress_error && std::isnan(record.error.stress)) note_without("stress", "stresses");
}

int score(const ScoreOptions& options) {
  const cases::Case c = codes::read_case(options.the_case);
  if (!options.db.empty()) require_keepable(c, options.the_case);
  const std::optional<codes::Adapter> adapter = adapter_of(c);
  const codes::OutputFiles usual = adapter ? adapter->output : codes::OutputFiles{};
  codes::Columns columns = columns_in(options, c, usual.columns);
  const std::string format = format_of(options, usual);
  const auto paths = [](const std::vector<std::string>& names) {
    return std::vector<std::filesystem::path>(names.begin(), names.end());
  };
  codes::Output output{.end = codes::read_snapshot(paths(options.outputs), columns, format)};
  columns.step.reset();
  if (!options.start.empty()) output.start = codes::read_snapshot(paths(options.start), columns, format);
  const records::Record record = adapter ? codes::score(c, adapter->stepping, output) : codes::score(c, output);
  const std::string files = fmt::format("{}", fmt::join(options.outputs, ", "));
  const bool is_failed = record.status == records::Status::failed;
  const std::string caution = record.status == records::Status::ok ? codes::caution(c) : "";
  if (!options.db.empty() && !is_failed) keep(record, options.db);
  if (options.json) {
    nlohmann::json json = record_json(record);
    if (c.scheme.code.empty()) json["scheme"] = nullptr;  // that of the case is our solver's, which has not run
    if (!caution.empty()) json["caution"] = caution;
    print_json(json);
  } else {
    print_score(record, files, output.end.digits);
  }
  if (!caution.empty()) note("mpmvv: {}\n", caution);
  if (record.status == records::Status::ok) note_missing_errors(record, files);
  if (!options.db.empty()) note("{} in {}\n", is_failed ? "the run failed: not kept" : "kept", options.db);
  return is_failed ? 1 : 0;
}

std::vector<std::string> format_words() {
  std::vector<std::string> words;
  for (const codes::Format& format : codes::formats()) words.push_back(format.word);
  return words;
}

}  // namespace

void add_score(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Score what another code wrote of a case, as a run is measured");
  command->add_option("case", options->the_case, "case that `mpmvv case` wrote")->required()->type_name("FILE");
  command->add_option("output", options->outputs, "the particles at its end; several files are parts of one state")
      ->required()
      ->type_name("FILE");
  command->add_option("--start", options->start, "the particles at time zero, where the end has no ids of the case")
      ->type_name("FILE");
  command
      ->add_option(
          "--format", options->format,
          fmt::format("of the files: {} (default: by name, else the adapter's)", fmt::join(format_words(), ", ")))
      ->type_name(word_of(format_words()));
  command->add_option("--columns", options->columns, "which columns hold what, by name or number")
      ->type_name("id=NAME,x=NAME,...");
  command->add_option("--step", options->step, "which one, of a dump with several (default: the last)")
      ->type_name("NUMBER");
  command->add_option("--length-unit", options->length, "of the files, in m (default: the adapter's, else 1)")
      ->type_name("NUMBER");
  command->add_option("--time-unit", options->time, "of the files, in s (default: the adapter's, else 1)")
      ->type_name("NUMBER");
  command->add_option("--mass-unit", options->mass, "of the files, in kg (default: the adapter's, else 1)")
      ->type_name("NUMBER");
  command->add_option("--thickness", options->thickness, "of a plane body: its masses are divided by it (default: 1)")
      ->type_name("METRES");
  command->add_option("--db", options->db, "keep the record in this store: a study takes it in place of a run")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "print the record as one JSON object");
  add_examples(*command, {"mpmvv score case.json end.csv", "mpmvv score case.json end.vtu --start start.vtu --json",
                          "mpmvv score case.json end.dump --columns id=tag,x=px,y=py --length-unit 1e-3",
                          "mpmvv score theirs.json end.csv --db results.db"});
  command->callback([options, &exit_code] { exit_code = score(*options); });
}

}  // namespace mpmvv::cli
