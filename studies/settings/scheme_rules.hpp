#pragma once
#include "studies/problems/problem.hpp"
#include "studies/settings/given.hpp"

namespace mpmvv::settings {

/// Sets what of the scheme has a rule of its own: the solver's words, and what only some of them take.
void complete_scheme(const Settings& settings, const problems::Problem& problem, bool quarter, cases::Scheme& scheme);

}  // namespace mpmvv::settings
