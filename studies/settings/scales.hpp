#pragma once
#include <string>

#include "studies/problems/setup.hpp"

namespace mpmvv::settings {

/// Throws UsageError where a quantity that follows from the choice (wave speed, mass, energy, ...) does not have a size
/// that a run can work with (studies/cases/setting.hpp). `given` names in the message the setting that is the likely
/// cause.
void require_scales(const cases::ProblemChoice& choice, const problems::Problem& problem, const std::string& given);

/// Throws UsageError where a quantity that follows from the whole case (cell width, time step, a particle's mass, ...)
/// does not have such a size.
void require_scales(const cases::Case& c, const problems::Problem& problem, const std::string& given);

}  // namespace mpmvv::settings
