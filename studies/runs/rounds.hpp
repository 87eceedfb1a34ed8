#pragma once
#include <functional>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Runs cases whose cost is measured and returns their records. The cost of each sound run is then measured as often as
/// its case says (`repeat`) by `run_again`, of whose record only cost and status count; the run itself does not count,
/// as it finds the machine cold. The cases take turns in rounds, every other round in reversed order, so that a slow
/// spell of the machine meets all alike. The geometric mean is kept, and the rounds. The record of a repetition that is
/// not sound replaces that of the run, and has no cost.
std::vector<records::Record> run_in_rounds(const std::vector<cases::Case>& cases,
                                           const std::function<records::Record(const cases::Case&)>& run,
                                           const std::function<records::Record(const cases::Case&)>& run_again);

}  // namespace mpmvv::runs
