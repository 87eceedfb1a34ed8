#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "solver/boundary/mirror.hpp"
#include "solver/boundary/periodic.hpp"
#include "studies/problems/parameters.hpp"
#include "studies/problems/setup.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::problems {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all{
      bar_problem(),             //
      square_problem(),          //
      cube_problem(),            //
      ring_problem(),            //
      vortex_problem(),          //
      shell_problem(),           //
      impact_problem(),          //
      stretch_problem(),         //
      stretch_1d_problem(),      //
      stretch_3d_problem(),      //
      pulse_problem(),           //
      shock_problem(),           //
      swing_problem(),           //
      bar_rest_problem(),        //
      square_rest_problem(),     //
      square_inverse_problem(),  //
      cube_rest_problem(),       //
      wave_problem(),            //
      translation_problem(),     //
      one_particle_problem(),    //
  };
  return all;
}

const Problem& find_problem(const std::string& name, const std::string& where) {
  return support::find_named(problems(), name, "problem", where);
}

void refuse_without_solution(const Problem& problem) {
  std::vector<std::string> others;
  for (const Problem& other : problems())
    if (other.has_solution(complete_parameters(other, {}))) others.push_back(other.name);
  throw support::UsageError(fmt::format("problem '{}' has no exact solution (problems that have one: {})", problem.name,
                                        fmt::join(others, ", ")));
}

Parameters complete_parameters(const Problem& problem, const Parameters& given) {
  Parameters all = given;
  for (const Parameter& parameter : problem.parameters) all.emplace(parameter.name, parameter.value);
  return all;
}

std::string Problem::default_boundary(bool quarter) const {
  return quarter ? quarter_boundary(boundary) : boundary;
}

std::string Problem::quarter_boundary(const std::string& word) const {
  const std::string mirror(solver::Mirror::word), other = word == solver::Periodic::word ? mirror : word;
  const bool is_lower = symmetry_planes == SymmetryPlanes::at_lower_faces;
  std::vector<std::string> faces;
  for (int d = 0; d < dimension(); ++d)
    faces.push_back(
        fmt::format("{0}min={1},{0}max={2}", "xyz"[d], is_lower ? mirror : other, is_lower ? other : mirror));
  return fmt::format("{}", fmt::join(faces, ","));
}

bool Problem::has_solution(const Parameters& values) const {
  return std::visit([&values](auto make) { return make(values).solution != nullptr; }, setup);
}

bool Problem::has_speed(const Parameters& values) const {
  return std::visit([&values](auto make) { return make(values).speed > 0; }, setup);
}

bool Problem::has_wall(const Parameters& values, std::size_t face) const {
  return std::visit([&](auto make) { return make(values).walls[face] != nullptr; }, setup);
}

bool Problem::is_curved(const Parameters& values) const {
  const auto curved = [&values]<int D>(SetupFunction<D> make) {
    if constexpr (D == 1)
      return false;
    else
      return std::holds_alternative<Annulus<D>>(make(values).body);
  };
  return std::visit(curved, setup);
}

namespace {

/// Returns of(body, h) for the body of a case and its cell width.
template <class Of>
auto of_body(const cases::Case& c, const Of& of) {
  const Problem& problem = find_problem(c.problem.name, "the case");
  const double h = problem.length(c.problem.parameters) / c.resolution.cells;
  const auto of_setup = [&]<int D>(SetupFunction<D>) {
    return std::visit([&](const auto& body) { return of(body, h); }, make_setup<D>(problem, c.problem, h).body);
  };
  return std::visit(of_setup, problem.setup);
}

}  // namespace

Extent extent(const cases::Case& c) {
  return of_body(c, []<template <int> class Body, int D>(const Body<D>& body, double h) {
    const Domain<D> all = domain(body, h);
    const auto cells = Eigen::Map<const Eigen::Array<int, D, 1>>(all.cells.data()).template cast<double>();
    return Extent{volume(body) / std::pow(h, D), cells.prod()};
  });
}

std::vector<int> domain_cells(const cases::Case& c) {
  return of_body(c, [](const auto& body, double h) {
    const auto all = domain(body, h);
    return std::vector<int>(all.cells.begin(), all.cells.end());
  });
}

double least_cells_between_walls(const cases::Case& c, std::size_t axis) {
  constexpr int times = 400;
  constexpr double golden = 0.6180339887498949;  // no period has its multiples always at one phase
  const double T = c.resolution.dt * static_cast<double>(c.resolution.steps);
  const Problem& problem = find_problem(c.problem.name, "the case");
  const double h = problem.length(c.problem.parameters) / c.resolution.cells;
  const auto between = [&]<int D>(SetupFunction<D>) {
    const auto walls = make_setup<D>(problem, c.problem, h).walls;
    const auto &lower = walls[2 * axis], &upper = walls[2 * axis + 1];
    if (!lower || !upper) return std::numeric_limits<double>::infinity();
    const auto cells_at = [&](double t) { return (upper->position(t) - lower->position(t)) / h; };
    double least = std::min(cells_at(0), cells_at(T));
    for (int k = 1; k <= times; ++k) least = std::min(least, cells_at(T * std::fmod(k * golden, 1)));
    return least;
  };
  return std::visit(between, problem.setup);
}

double cfl_number(const cases::Case& c) {
  const Problem& problem = find_problem(c.problem.name, "the case");
  return problem.wave_speed(c.problem.parameters) * c.resolution.dt * c.resolution.cells /
         problem.length(c.problem.parameters);
}

double p_wave_cfl_number(const cases::Case& c) {
  const Problem& problem = find_problem(c.problem.name, "the case");
  const auto ratio = [&problem](const Parameters& p) {
    return p.contains("poissons_ratio") ? p_wave_speed(p) / problem.wave_speed(p) : 1;
  };
  return cfl_number(c) * ratio(c.problem.parameters) / ratio(complete_parameters(problem, {}));
}

}  // namespace mpmvv::problems
