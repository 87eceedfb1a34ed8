#include "studies/codes/conditions.hpp"

#include "studies/runs/prepared_case.hpp"
#include "studies/settings/boundaries.hpp"

namespace mpmvv::codes {

namespace {

/// Fills in the body, its density and the background grid.
template <int D>
void place(Conditions& all, const cases::Case& c, const problems::Problem& problem) {
  const auto setup = problems::make_setup<D>(problem, c.problem, all.h);
  const auto grid = runs::background_grid<D>(c, setup, all.h);
  all.body = std::visit([](const auto& body) { return problems::description(body); }, setup.body);
  all.density = setup.density;
  all.cells.assign(grid.cells.begin(), grid.cells.end());
  all.lower.assign(grid.lower.data(), grid.lower.data() + D);
  for (std::size_t d = 0; d < D; ++d) all.upper.push_back(all.lower[d] + grid.cells[d] * all.h);
}

}  // namespace

Conditions conditions(const cases::Case& c) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const auto& parameters = c.problem.parameters;
  Conditions all;
  all.dimension = problem.dimension();
  all.material = c.scheme.material;
  all.wave_speed = problem.wave_speed(parameters);
  all.length = problem.length(parameters);
  all.dt = c.resolution.dt;
  all.end_time = static_cast<double>(c.resolution.steps) * c.resolution.dt;
  all.boundary = settings::boundary_faces(c.scheme.boundary, all.dimension, "the case");
  all.h = all.length / c.resolution.cells;
  all.cfl = all.wave_speed * all.dt / all.h;
  if (parameters.contains("youngs_modulus")) all.elasticity = mms::elasticity(parameters);
  std::visit([&]<int D>(problems::SetupFunction<D>) { place<D>(all, c, problem); }, problem.setup);
  return all;
}

double bulk_modulus(const mms::Elasticity& material) {
  return material.lambda() + 2 * material.mu() / 3;
}

}  // namespace mpmvv::codes
