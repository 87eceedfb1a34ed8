#pragma once
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/problems/problem.hpp"

namespace mpmvv::settings {

/// Throws UsageError on a combination of choices that makes no sense, and says why. Each rule is an entry of one table.
void validate(const cases::Case& c, const problems::Problem& problem);

bool is_valid(const cases::Case& c, const problems::Problem& problem);

/// What each rule would say of this case.
std::vector<std::string> objections(const cases::Case& c, const problems::Problem& problem);

}  // namespace mpmvv::settings
