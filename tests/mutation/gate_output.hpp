#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"
#include "tests/mutation/mutant_schemata.hpp"

namespace mpmvv::mutation {

/// The numbers of the choices that a compiler's output complains of: those of which it names lines with the edit; where
/// there are none, those of which it names any line. `places` is by file.
std::set<int> choices_named(const std::string& output, const std::map<std::string, std::vector<ChoicePlace>>& places);

/// The first test that failed, as a test program printed; without one, the test during which the program ended.
std::string failed_test(const std::string& output);

/// "study: golden" of what does not pass, from `mpmvv gate --json`; what is inconclusive is marked, and comes last.
std::vector<std::string> goldens_not_passed(const std::string& json);

/// Judges study by study, up to the first with a failure: most mistakes need no more than the first few studies.
/// Inconclusive goldens count only where nothing fails.
Trial first_catch(GateStage stage, const std::vector<std::string>& studies,
                  const std::function<std::vector<std::string>(const std::string& study)>& complaints_of);

}  // namespace mpmvv::mutation
