#include "studies/codes/wall_expressions.hpp"

#include "mms/expression/formulas.hpp"
#include "solver/boundary/wall.hpp"
#include "studies/problems/setup.hpp"
#include "studies/settings/boundaries.hpp"

namespace mpmvv::codes {

namespace {

namespace expression = mms::expression;

/// Returns the motion of the material at X along an axis, to which a wall there is bound.
WallExpressions motion_at(double X, std::size_t axis, const expression::Fields& fields,
                          const expression::Dialect& dialect) {
  const auto at_wall = [&](const expression::Traced& component) {
    return substitute(component, static_cast<expression::Variable>(axis), X);
  };
  try {
    return {text(X + at_wall(fields.u[axis]), dialect), text(at_wall(fields.v[axis]), dialect)};
  } catch (const expression::NotWritable&) {
    return {};
  }
}

template <int D>
std::vector<WallExpressions> motions(const cases::Case& c, const problems::Problem& problem,
                                     const expression::Dialect& dialect) {
  std::vector<WallExpressions> all(2 * D);
  const auto setup = problems::make_setup<D>(problem, c.problem, 0);
  const auto formulas = setup.solution ? setup.solution->formulas() : expression::Formulas{};
  if (!formulas.reference) return all;
  const auto faces = settings::boundary_faces(c.scheme.boundary, D, "the case");
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (faces[k] == solver::Wall::word && setup.walls[k])
      all[k] = motion_at(setup.walls[k]->position(0), k / 2, *formulas.reference, dialect);
  return all;
}

}  // namespace

std::vector<WallExpressions> wall_expressions(const cases::Case& c, const expression::Dialect& dialect) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  return std::visit([&]<int D>(problems::SetupFunction<D>) { return motions<D>(c, problem, dialect); }, problem.setup);
}

}  // namespace mpmvv::codes
