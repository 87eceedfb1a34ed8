#pragma once
#include <vector>

#include "studies/plan/study.hpp"

namespace mpmvv::plan {

/// Makes every case of a series, to check it: UsageError where one is wrong or two that should differ are the same.
void try_cases(const StudyPlan& plan, const SeriesPlan& series);

/// Puts the settings on top of the series' own, and into the text that the store keeps; a check takes none. UsageError
/// on an unknown key, and on one that the study varies itself unless the setting is `where_taken`.
void override_series(const std::vector<Overriding>& settings, StudyPlan& plan);

}  // namespace mpmvv::plan
