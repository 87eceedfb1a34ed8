#pragma once
#include <optional>

#include "solver/boundary/images.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::settings {

/// The part of a case's body that is run in place of the whole, because the rest consists of its images.
struct Part {
  cases::Case body;                              ///< the case itself, or that of its quarter
  int mirror_images = 1;                         ///< number of quarters that make up the case's body
  solver::Images images = solver::Images::none;  ///< images that make `body` out of the particles that are run

  int count() const { return mirror_images * solver::count(images); }
};

/// Returns the part of this case. There is none where the case, the problem, the boundary, the grid or the numbers to
/// be measured do not allow it, and where no test has shown that the numbers are the same
/// (tests/studies/runs/part_test.cpp).
std::optional<Part> part_of(const cases::Case& c);

/// Returns the case with `whole` set where it could also be run by a part, and not set where the whole body is run
/// anyway.
cases::Case as_whole(cases::Case c);

}  // namespace mpmvv::settings
