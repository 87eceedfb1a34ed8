#pragma once
#include <vector>

#include "reports/report.hpp"

namespace mpmvv::cli {

/// How to repeat the runs of a study's series with `mpmvv run`: those of its sweep and those of the search of its
/// limit. None for a check, and for a study that this program would not read any more.
std::vector<reports::SeriesCommand> case_commands(const records::StudyResult& study);

/// The dimension of the bodies of a study's series; 0 where they differ, and where there are no series to read.
int dimension_of(const records::StudyResult& study);

/// How to repeat a study: by its name where it comes with the program, else by its file; with the options of a trial.
reports::StudyCall study_call(const records::StudyResult& study);

}  // namespace mpmvv::cli
