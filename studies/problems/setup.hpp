#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <variant>

#include "mms/solution.hpp"
#include "solver/boundary/wall_motion.hpp"
#include "solver/material/materials.hpp"
#include "studies/problems/body.hpp"
#include "studies/problems/problem.hpp"
#include "studies/support/not_measured.hpp"

namespace mpmvv::problems {

/// A law that the body may have instead of the problem's own. With it the body moves nearly as the solution.
struct OtherLaw {
  solver::AnyMaterial material;
  std::function<double(double t)> solution_error;  ///< bound of the RMS displacement error of the solution, m
};

/// The data of a problem for its runs: the body at rest, its material, its motion and its walls.
template <int D>
struct Setup {
  Body<D> body = Cuboid<D>{};
  double density = 0;  ///< kg/m³
  solver::AnyMaterial material;
  std::shared_ptr<mms::ManufacturedSolution<D>> solution = nullptr;  ///< null where no exact solution is known
  std::function<solver::Vec<D>(const solver::Vec<D>&)> start_velocity = nullptr;  ///< m/s; used without a solution
  std::array<std::shared_ptr<solver::WallMotion>, 2 * D> walls = {};  ///< by face; null: the problem has none there
  double speed = 0;  ///< m/s, what velocity errors are relative to; 0: the problem has none
  std::optional<OtherLaw> other_law = {};
};

/// Gives the body the law with this word. Removes `other_law` where it is not the law chosen.
template <int D>
void choose_law(Setup<D>& setup, const Problem& problem, const std::string& material) {
  if (material == problem.material)
    setup.other_law.reset();
  else
    setup.material = setup.other_law->material;
}

/// Returns a bound of the RMS displacement error of the solution itself at time t, m; `not_measured` where the solution
/// is exact for the law that `choose_law` has set.
template <int D>
double solution_floor(const Setup<D>& setup, double t) {
  return setup.other_law ? setup.other_law->solution_error(t) : support::not_measured;
}

/// Returns the setup of a choice, with the whole body or its quarter. `h` is the cell width, for bodies that depend on
/// it.
template <int D>
Setup<D> make_setup(const Problem& problem, const cases::ProblemChoice& choice, double h) {
  Setup<D> setup = std::get<SetupFunction<D>>(problem.setup)(choice.parameters);
  if (auto* box = std::get_if<Box<D>>(&setup.body)) box->reach = box->end_speed * choice.end_time;
  if constexpr (D > 1) {
    if (auto* annulus = std::get_if<Annulus<D>>(&setup.body)) annulus->quarter = choice.quarter;
    if (auto* blocks = std::get_if<Blocks<D>>(&setup.body))
      blocks->quarter = choice.quarter, blocks->gap = blocks->gap_cells * h;
  }
  if (auto* cuboid = std::get_if<Cuboid<D>>(&setup.body); cuboid && choice.quarter) cuboid->length /= 2;
  return setup;
}

}  // namespace mpmvv::problems
