#pragma once
#include "studies/plan/study.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv {

/// One `[[criterion]]` of a study file whose series, sweep and limit are read. UsageError with file and line.
Criterion read_criterion(const TomlTable& table, const StudyPlan& plan);

}  // namespace mpmvv
