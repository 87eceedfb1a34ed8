#pragma once
#include <string>
#include <vector>

#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::cli {

/// Prints what a store (an absent one is empty) lacks of the studies' work, how long that takes on `jobs` cores, and
/// why. The times are those of the store `costs`, or where it is null of the first one.
void print_forecast(const std::vector<plan::StudyPlan>& plans, const plan::Work& work, const std::string& db,
                    const store::Store* costs, int jobs, bool as_json);

}  // namespace mpmvv::cli
