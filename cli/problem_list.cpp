#include "cli/problem_list.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/console.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"
#include "solver/boundary/boundaries.hpp"
#include "studies/problems/problem.hpp"
#include "studies/support/not_measured.hpp"

namespace mpmvv::cli {

using problems::Problem;
using Kind = Table::Kind;

namespace {

/// What the default boundary costs in order, as studies found (docs/problems.md); empty where no study has looked.
std::string boundary_cost(const Problem& p, const problems::Parameters& defaults) {
  if (p.boundary == solver::Periodic::word) return "none";
  if (p.boundary == solver::Symmetry::word) return "splines: order about 1, mirror: 2";
  if (p.boundary == solver::Free::word && p.is_curved(defaults))
    return "stairs of a lattice: order about 1, fill conforming: up to 2";
  return "";
}

nlohmann::json problem_json(const Problem& p) {
  const problems::Parameters defaults = problems::complete_parameters(p, {});
  nlohmann::json parameters = nlohmann::json::array();
  for (const problems::Parameter& parameter : p.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"default", parameter.value},
                          {"unit", parameter.unit},
                          {"allowed", parameter.range}});
  return {{"name", p.name},
          {"source", p.source},
          {"dimension", p.dimension()},
          {"length", {{"formula", p.length_formula}, {"default", p.length(defaults)}}},
          {"wave_speed", {{"formula", p.wave_speed_formula}, {"default", p.wave_speed(defaults)}}},
          {"end_time",
           {{"formula", p.end_time_formula}, {"default", p.lead_time ? support::not_measured : p.end_time(defaults)}}},
          {"boundary", p.boundary},
          {"boundary_costs", boundary_cost(p, defaults)},
          {"parameters", parameters}};
}

/// The default boundary, faces apart so that a line can break between them.
std::string boundary_text(const Problem& p) {
  std::string text;
  for (const char letter : p.boundary) text += letter == ',' ? ", " : std::string(1, letter);
  return text;
}

void print_values(const Problem& p) {
  print("\n");
  print_indented(fmt::format("{}: {}", p.name, p.source), 0);
  print_indented(
      fmt::format("L = {}, wave speed {}, end time {}", p.length_formula, p.wave_speed_formula, p.end_time_formula));
  Table table({{"parameter"}, {"default", Kind::number}, {"unit"}, {"allowed", Kind::prose}}, 4);
  for (const problems::Parameter& parameter : p.parameters)
    table.add({parameter.name, fmt::format("{:g}", parameter.value), parameter.unit, parameter.range});
  table.print();
}

}  // namespace

nlohmann::json problem_list() {
  nlohmann::json all = nlohmann::json::array();
  for (const Problem& p : problems::problems()) all.push_back(problem_json(p));
  return all;
}

void print_problems() {
  Table table({{"problem"},
               {"in"},
               {"L (m)", Kind::number},
               {"wave speed\n(m/s)", Kind::number},
               {"end time\n(s)", Kind::number},
               {"default boundary\n(its cost in order)", Kind::prose}},
              0);
  for (const Problem& p : problems::problems()) {
    const problems::Parameters defaults = problems::complete_parameters(p, {});
    const std::string cost = boundary_cost(p, defaults);
    table.add({p.name, fmt::format("{}D", p.dimension()), number_text(p.length(defaults)),
               number_text(p.wave_speed(defaults)), p.lead_time ? "see below" : number_text(p.end_time(defaults)),
               cost.empty() ? boundary_text(p) : fmt::format("{} ({})", boundary_text(p), cost)});
  }
  table.print();
  for (const Problem& p : problems::problems()) print_values(p);
}

}  // namespace mpmvv::cli
