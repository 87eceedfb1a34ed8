#pragma once
#include <optional>

#include "solver/boundary/images.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::settings {

/// What may be run of a case, as the rest is images of it.
struct Part {
  cases::Case body;                              ///< the case's, or the one of its quarter
  int mirror_images = 1;                         ///< quarters that make the case's body
  solver::Images images = solver::Images::none;  ///< of the particles of `body` that are run

  int count() const { return mirror_images * solver::count(images); }
};

/// None where the case, or the problem, the boundary, the grid or what is measured does not allow it, and where no test
/// has shown that the numbers are the same (tests/studies/runs/part_test.cpp).
std::optional<Part> part_of(const cases::Case& c);

/// The case that runs the whole body; where nothing else is possible, the case as it is.
cases::Case as_whole(cases::Case c);

}  // namespace mpmvv::settings
