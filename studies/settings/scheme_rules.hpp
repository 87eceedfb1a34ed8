#pragma once
#include "studies/problems/problem.hpp"
#include "studies/settings/given.hpp"

namespace mpmvv::settings {

/// Sets those members of the scheme that have a rule of their own: the solver's words, and the values that only some of
/// these words take.
void complete_scheme(const Settings& settings, const problems::Problem& problem, bool quarter, cases::Scheme& scheme);

}  // namespace mpmvv::settings
