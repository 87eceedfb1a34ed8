#include "studies/codes/score.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/record_json.hpp"
#include "cli/run_text.hpp"
#include "studies/cases/setting.hpp"
#include "studies/codes/case_file.hpp"
#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

struct ScoreOptions {
  std::string the_case;
  std::vector<std::string> outputs, start;
  std::string format, columns, step;
  std::string length = "1", time = "1", mass = "1";
  bool json = false;
};

codes::Columns columns_in(const ScoreOptions& options) {
  codes::Columns columns;
  if (!options.columns.empty()) columns.names = codes::parse_columns(options.columns, "--columns");
  columns.length = cases::positive({"length unit", options.length, "--length-unit"});
  columns.time = cases::positive({"time unit", options.time, "--time-unit"});
  columns.mass = cases::positive({"mass unit", options.mass, "--mass-unit"});
  if (!options.step.empty()) columns.step = cases::whole({"step", options.step, "--step"}, 0, 1'000'000'000'000);
  return columns;
}

int score(const ScoreOptions& options) {
  const cases::Case c = codes::read_case(options.the_case);
  codes::Columns columns = columns_in(options);
  const auto paths = [](const std::vector<std::string>& names) {
    return std::vector<std::filesystem::path>(names.begin(), names.end());
  };
  codes::Output output{.end = codes::read_snapshot(paths(options.outputs), columns, options.format)};
  columns.step.reset();
  if (!options.start.empty()) output.start = codes::read_snapshot(paths(options.start), columns, options.format);
  const records::Record record = codes::score(c, output);
  if (options.json)
    print_json(record_json(record));
  else
    print_score(record, fmt::format("{}", fmt::join(options.outputs, ", ")), output.end.digits);
  return record.status == records::Status::failed ? 1 : 0;
}

std::string format_words() {
  std::vector<std::string> words;
  for (const codes::Format& format : codes::formats()) words.push_back(format.word);
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

void add_score(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Score what another code wrote of a case, as a run is measured");
  command->add_option("case", options->the_case, "case that `mpmvv case` wrote")->required()->type_name("FILE");
  command->add_option("output", options->outputs, "the particles at its end; several files are parts of one state")
      ->required()
      ->type_name("FILE ...");
  command->add_option("--start", options->start, "the particles at time zero, where the end has no ids of the case")
      ->type_name("FILE");
  command->add_option("--format", options->format, fmt::format("of the files: {} (default: by name)", format_words()))
      ->type_name("WORD");
  command->add_option("--columns", options->columns, "which columns hold what, by name or number")
      ->type_name("id=NAME,x=NAME,...");
  command->add_option("--step", options->step, "which one, of a dump with several (default: the last)")
      ->type_name("NUMBER");
  command->add_option("--length-unit", options->length, "of the files, in m (default: 1)")->type_name("NUMBER");
  command->add_option("--time-unit", options->time, "of the files, in s (default: 1)")->type_name("NUMBER");
  command->add_option("--mass-unit", options->mass, "of the files, in kg (default: 1)")->type_name("NUMBER");
  command->add_flag("--json", options->json, "print the record as one JSON object");
  add_examples(*command, {"mpmvv score case.json end.csv", "mpmvv score case.json end.vtu --start start.vtu --json",
                          "mpmvv score case.json end.dump --columns id=tag,x=px,y=py --length-unit 1e-3"});
  command->callback([options, &exit_code] { exit_code = score(*options); });
}

}  // namespace mpmvv::cli
