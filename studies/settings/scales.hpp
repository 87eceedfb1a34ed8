#pragma once
#include <string>

#include "studies/problems/problem.hpp"

namespace mpmvv::settings {

/// What a run can work with: products of two such sizes are numbers with all their digits.
constexpr double least_size = 1e-150, largest_size = 1e150;
bool has_size(double value);

/// Throws UsageError where what follows from the choice (wave speed, mass, energy, ...) has no such size. `given` says
/// in the message what it was, and where.
void require_scales(const cases::ProblemChoice& choice, const problems::Problem& problem, const std::string& given);

/// Throws UsageError where what follows from the whole case (cell width, time step, a particle's mass, ...) has no such
/// size.
void require_scales(const cases::Case& c, const problems::Problem& problem, const std::string& given);

}  // namespace mpmvv::settings
