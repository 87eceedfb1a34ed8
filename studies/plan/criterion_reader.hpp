#pragma once
#include "studies/plan/study.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::plan {

/// One `[[criterion]]` of a study file whose series, sweep and limit are read. UsageError with file and line.
claims::Criterion read_criterion(const support::TomlTable& table, const StudyPlan& plan);

}  // namespace mpmvv::plan
