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

/// A law that the body may be of instead of the problem's own, by which it moves nearly as the solution says.
struct OtherLaw {
  solver::AnyMaterial material;
  std::function<double(double t)> solution_error;  ///< RMS displacement error of the solution, m, at most
};

/// What a problem hands to the runner: the body at rest in its domain and how it starts.
template <int D>
struct Setup {
  Body<D> body = Cuboid<D>{};
  double density = 0;  ///< kg/m³
  solver::AnyMaterial material;
  std::shared_ptr<mms::ManufacturedSolution<D>> solution = nullptr;  ///< null where no exact solution is known
  std::function<solver::Vec<D>(const solver::Vec<D>&)> start_velocity = nullptr;  ///< used when there is no solution
  std::array<std::shared_ptr<solver::WallMotion>, 2 * D> walls = {};              ///< by face; null where none can be
  double speed = 0;  ///< of the problem, m/s, which velocity errors are measured by; 0: it has none
  std::optional<OtherLaw> other_law = {};
};

/// Makes the body of this law; `other_law` stays only where it is that one.
template <int D>
void choose_law(Setup<D>& setup, const Problem& problem, const std::string& material) {
  if (material == problem.material)
    setup.other_law.reset();
  else
    setup.material = setup.other_law->material;
}

/// RMS displacement error of the solution itself by time t, m, at most; not measured where it is exact for the law that
/// was chosen.
template <int D>
double solution_floor(const Setup<D>& setup, double t) {
  return setup.other_law ? setup.other_law->solution_error(t) : support::not_measured;
}

/// The setup of a choice: the whole body, or its quarter. `h` is the cell width, for bodies that depend on it.
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
