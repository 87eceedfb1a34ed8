#pragma once
#include "studies/problems/problem.hpp"
#include "studies/settings/given.hpp"

/// Rules for cases that another code solves (`code`). Such cases do not have the settings of our own solver.
namespace mpmvv::settings {

/// Throws UsageError on a key that cases of the chosen code do not have. Where no code is chosen, these are the keys of
/// other codes.
void require_keys_of_code(const Settings& settings);

/// Throws UsageError, with the reason, where no other code can run a case, or nothing can be measured in it.
void validate_other_code(const cases::Case& c, const problems::Problem& problem);

}  // namespace mpmvv::settings
