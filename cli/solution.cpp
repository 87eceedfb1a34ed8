#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <numeric>
#include <sstream>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/numbers.hpp"
#include "studies/codes/solution_points.hpp"
#include "studies/problems/fields.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

struct SolutionOptions {
  std::string problem, at, points, time, normal, fields;
  std::vector<std::string> parameters;
  bool json = false;
};

/// The parts between commas. A comma at the end leaves an empty part.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream parts(text.ends_with(',') ? text + ',' : text);
  for (std::string part; std::getline(parts, part, ',');) all.push_back(part);
  return all;
}

std::vector<double> coordinates(const std::string& text, int dimension, const std::string& option) {
  std::vector<double> X;
  for (const std::string& part : parts_of(text)) X.push_back(settings::parse_number({"coordinate", part, option}));
  if (static_cast<int>(X.size()) != dimension)
    throw UsageError(
        fmt::format("{} {} has {} (the problem has {})", option, text, count_text(X.size(), "coordinate"), dimension));
  return X;
}

double time_of(const SolutionOptions& options) {
  return settings::parse_number({"time", options.time, "--time"});
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

std::string content_of(const std::string& points) {
  const std::string wanted = "CSV with columns X, ... and t";
  std::string content =
      points == "-" ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : support::require_file(points, wanted);
  if (content.find('\0') != std::string::npos)
    throw UsageError(fmt::format("--points {} is no text: it has bytes of 0 ({})", points, wanted));
  return content;
}

std::vector<std::string> fields_of(const std::string& text) {
  const auto known = codes::solution_fields();
  std::vector<std::string> fields = parts_of(text);
  for (const std::string& field : fields) {
    if (std::ranges::find(known, field) == known.end())
      throw UsageError(fmt::format("unknown field '{}' in --fields (known: {})", field, fmt::join(known, ", ")));
    if (std::ranges::count(fields, field) > 1)
      throw UsageError(fmt::format("field '{}' stands twice in --fields (each once)", field));
  }
  return fields;
}

/// Throws where a normal is given that no field takes.
void require_use_of_normal(const SolutionOptions& options, const std::vector<std::string>& fields) {
  if (!options.normal.empty() && !fields.empty() && std::ranges::find(fields, "traction") == fields.end())
    throw UsageError(fmt::format("--normal without traction in --fields (--fields {},traction)", options.fields));
}

int solution_at_points(const problems::Problem& problem, const SolutionOptions& options) {
  const std::string content = content_of(options.points);
  const std::vector<std::string> fields = fields_of(options.fields);  // inside the braces g++ 12 frees twice on a throw
  codes::PointQuery query{.points = {content, options.points == "-" ? "standard input" : options.points},
                          .fields = fields};
  require_use_of_normal(options, query.fields);
  if (!options.time.empty()) query.time = time_of(options);
  if (!options.normal.empty()) query.normal = coordinates(options.normal, problem.dimension(), "--normal");
  codes::solution_at(choice_of(problem, options.parameters), query, print_text);
  return 0;
}

/// P N for the unit vector along the normal, which may have any length.
std::vector<double> traction(const nlohmann::json& P, std::vector<double> N) {
  const double length = std::sqrt(std::inner_product(N.begin(), N.end(), N.begin(), 0.0));
  if (!(length > 0)) throw UsageError("--normal has no direction (numbers that are not all 0)");
  std::vector<double> T;
  for (const auto& row : P.get<std::vector<std::vector<double>>>())
    T.push_back(std::inner_product(row.begin(), row.end(), N.begin(), 0.0) / length);
  return T;
}

int solution(const SolutionOptions& options) {
  const problems::Problem& problem = problems::find_problem(options.problem, "--problem");
  if (!options.points.empty()) return solution_at_points(problem, options);
  if (options.at.empty()) throw UsageError("--at or --points is required by `mpmvv solution` (where it is asked for)");
  if (options.time.empty()) throw UsageError("--time is required by `mpmvv solution` with --at (s)");
  const cases::ProblemChoice choice = choice_of(problem, options.parameters);
  const auto at = coordinates(options.at, problem.dimension(), "--at");
  nlohmann::json json = evaluate(problem, choice, at, time_of(options));
  if (!options.normal.empty())
    json["traction"] = traction(json["P"], coordinates(options.normal, problem.dimension(), "--normal"));
  require_finite(json, options);
  if (options.json) {
    print_json(json);
    return 0;
  }
  for (const char* name : {"u", "v", "a", "b", "F", "P", "traction"})
    if (json.contains(name)) print("{} = {}\n", name, json[name].dump());
  return 0;
}

}  // namespace

void add_solution(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SolutionOptions>();
  CLI::App* command = app.add_subcommand("solution", "Print u, v, a, F, P and b of a solution at reference points");
  command->add_option("--problem", options->problem, "which solution")->required()->type_name("WORD");
  CLI::Option* at = command->add_option("--at", options->at, "reference point in m")->type_name("X[,Y[,Z]]");
  CLI::Option* points =
      command
          ->add_option(
              "--points", options->points,
              "CSV file of many, - for standard input, with columns X, Y and Z as far as the problem has them, "
              "t, and NX, NY and NZ of a normal; others are left alone. A CSV is printed, with 17 digits")
          ->type_name("FILE")
          ->excludes(at);
  command->add_option("--time", options->time, "in s (required, but for points with a column t)")->type_name("NUMBER");
  command
      ->add_option("--normal", options->normal,
                   "of a surface, of any length, for its traction P N: the force per area at rest")
      ->type_name("NX[,NY[,NZ]]");
  command
      ->add_option("--fields", options->fields,
                   "of the points: u, v, a, b, F, P, traction, between commas (default: all)")
      ->type_name("WORDS")
      ->needs(points);
  command->add_option("--param", options->parameters, "physical value of the problem (repeatable)")
      ->type_name("NAME=VALUE");
  command->add_flag("--json", options->json, "print one JSON object")->excludes(points);
  add_examples(*command, {"mpmvv solution --problem bar --at 0.2 --time 0.001",
                          "mpmvv solution --problem square --points points.csv --fields u,P,traction --normal 1,0",
                          "mpmvv solution --problem ring --at 0.6,0.3 --time 0.01 --param poissons_ratio=0.3 --json"});
  command->callback([options, &exit_code] { exit_code = solution(*options); });
}

}  // namespace mpmvv::cli
