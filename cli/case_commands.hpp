#pragma once
#include <vector>

#include "reports/report.hpp"

namespace mpmvv::cli {

/// How to repeat the runs of a study's series with `mpmvv run`. None for a check, and for a study that this program
/// would not read any more.
std::vector<reports::SeriesCommand> case_commands(const records::StudyResult& study);

}  // namespace mpmvv::cli
