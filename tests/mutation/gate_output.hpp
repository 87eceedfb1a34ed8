#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"
#include "tests/mutation/mutant_schemata.hpp"

namespace mpmvv::mutation {

/// The numbers of the choices, given by their files, of which a compiler's output names lines with the edit; where
/// there is none, of those of which it names any line.
std::set<int> choices_named(const std::string& output, const std::map<std::string, std::vector<ChoicePlace>>& places);

/// The first test that failed by what a test program printed; with none, the one in which it ended.
std::string failed_test(const std::string& output);

/// "study: golden" of what does not pass, from `mpmvv gate --json`; what is inconclusive is marked, and comes last.
std::vector<std::string> goldens_not_passed(const std::string& json);

/// Study by study up to the first of which anything fails: most mistakes need no more than the first few. What is
/// inconclusive alone counts where nothing fails.
Trial first_catch(GateStage stage, const std::vector<std::string>& studies,
                  const std::function<std::vector<std::string>(const std::string& study)>& complaints_of);

}  // namespace mpmvv::mutation
