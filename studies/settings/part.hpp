#pragma once
#include <optional>

#include "studies/cases/case.hpp"

namespace mpmvv::settings {

/// The case of the part that a study may run instead of the whole, as the rest is its mirror images: the quarter of the
/// body. None where the case, or the problem, the boundary, the grid or what is measured does not allow it, and where
/// no test has shown that the numbers are the same (tests/studies/runs/part_test.cpp).
std::optional<cases::Case> part_of(const cases::Case& c);

/// The part and its images, which make the whole.
int images_of_part(const cases::Case& part);

/// The case that runs the whole body in a study, too; where nothing else is possible, the case as it is.
cases::Case as_whole(cases::Case c);

}  // namespace mpmvv::settings
