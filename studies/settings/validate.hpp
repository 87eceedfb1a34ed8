#pragma once
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/problems/problem.hpp"

namespace mpmvv::settings {

/// Throws UsageError, with the reason, on a combination of choices that makes no sense. Each rule is an entry of one
/// table.
void validate(const cases::Case& c, const problems::Problem& problem);

bool is_valid(const cases::Case& c, const problems::Problem& problem);

/// Whether the case is a quarter that ends between nodes. It ends at planes through the middle of the whole body's
/// domain.
bool ends_between_nodes(const cases::Case& c);

/// Returns the message of every rule, broken or not, as it would read for this case.
std::vector<std::string> objections(const cases::Case& c, const problems::Problem& problem);

}  // namespace mpmvv::settings
