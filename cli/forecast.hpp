#pragma once
#include <string>
#include <vector>

#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"

namespace mpmvv::cli {

/// Prints what a store (an absent one is empty) lacks of the studies' work, how long that takes on `jobs` cores, and
/// why.
void print_forecast(const std::vector<plan::StudyPlan>& plans, const plan::Work& work, const std::string& db, int jobs,
                    bool as_json);

}  // namespace mpmvv::cli
