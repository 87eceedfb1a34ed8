#pragma once
#include <array>
#include <functional>
#include <memory>
#include <variant>

#include "mms/solution.hpp"
#include "solver/boundary/wall_motion.hpp"
#include "solver/material/materials.hpp"
#include "studies/problems/body.hpp"
#include "studies/problems/problem.hpp"

namespace mpmvv::problems {

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
};

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
