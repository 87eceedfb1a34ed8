#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "studies/problems/fields.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

struct SolutionOptions {
  std::string problem, at, time;
  std::vector<std::string> parameters;
  bool json = false;
};

std::vector<double> coordinates(const std::string& text, int dimension) {
  std::vector<double> X;
  std::istringstream parts(text.ends_with(',') ? text + ',' : text);  // so that a trailing comma is an empty part
  for (std::string part; std::getline(parts, part, ',');)
    X.push_back(settings::parse_number({"coordinate", part, "--at"}));
  if (static_cast<int>(X.size()) != dimension)
    throw UsageError(fmt::format("--at {} has {} coordinates (the problem has {})", text, X.size(), dimension));
  return X;
}

cases::ProblemChoice choice_of(const problems::Problem& problem, const std::vector<std::string>& texts) {
  std::vector<settings::Setting> settings{{"problem", problem.name, "--problem"}};
  for (const std::string& text : texts) settings.push_back(parameter_setting(text));
  return settings::make_choice(settings);
}

nlohmann::json evaluate(const problems::Problem& problem, const cases::ProblemChoice& choice,
                        const std::vector<double>& at, double t) {
  const problems::Fields fields = problems::fields_at(problem, choice, at, t, "--at");
  return {{"problem", problem.name},
          {"parameters", choice.parameters},
          {"at", at},
          {"time", t},
          {"u", fields.u},
          {"v", fields.v},
          {"a", fields.a},
          {"b", fields.b},
          {"F", fields.F},
          {"P", fields.P}};
}

/// Refuses a time or place at which a field overflows.
void require_finite(const nlohmann::json& fields, const SolutionOptions& options) {
  const nlohmann::json flat = fields.flatten();
  for (const auto& [path, value] : flat.items())
    if (value.is_number_float() && !std::isfinite(value.get<double>()))
      throw UsageError(fmt::format("{} of problem '{}' is not finite with --at {} and --time {} (a time nearer to 0)",
                                   path.substr(1), options.problem, options.at, options.time));
}

int solution(const SolutionOptions& options) {
  const problems::Problem& problem = problems::find_problem(options.problem, "--problem");
  const cases::ProblemChoice choice = choice_of(problem, options.parameters);
  const auto at = coordinates(options.at, problem.dimension());
  const double t = settings::parse_number({"time", options.time, "--time"});
  const nlohmann::json json = evaluate(problem, choice, at, t);
  require_finite(json, options);
  if (options.json) {
    print_json(json);
    return 0;
  }
  for (const char* name : {"u", "v", "a", "b", "F", "P"}) print("{} = {}\n", name, json[name].dump());
  return 0;
}

}  // namespace

void add_solution(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SolutionOptions>();
  CLI::App* command = app.add_subcommand("solution", "Print u, v, a, F, P and b of a solution at a reference point");
  command->add_option("--problem", options->problem, "which solution")->required()->type_name("WORD");
  command->add_option("--at", options->at, "reference point in m")->required()->type_name("X[,Y[,Z]]");
  command->add_option("--time", options->time, "in s")->required()->type_name("NUMBER");
  command->add_option("--param", options->parameters, "physical value of the problem (repeatable)")
      ->type_name("NAME=VALUE");
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command, {"mpmvv solution --problem bar --at 0.2 --time 0.001",
                          "mpmvv solution --problem ring --at 0.6,0.3 --time 0.01 --param poissons_ratio=0.3 --json"});
  command->callback([options, &exit_code] { exit_code = solution(*options); });
}

}  // namespace mpmvv::cli
