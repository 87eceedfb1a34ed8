#pragma once
#include <string>

#include "studies/problems/setup.hpp"

namespace mpmvv::settings {

/// Throws UsageError where what follows from the choice (wave speed, mass, energy, ...) is of no size that
/// a run can work with (studies/cases/setting.hpp). `given` says in the message what it was, and where.
void require_scales(const cases::ProblemChoice& choice, const problems::Problem& problem, const std::string& given);

/// Throws UsageError where what follows from the whole case (cell width, time step, a particle's mass, ...) has no such
/// size.
void require_scales(const cases::Case& c, const problems::Problem& problem, const std::string& given);

}  // namespace mpmvv::settings
