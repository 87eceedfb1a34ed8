#pragma once
#include <functional>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Measures the cost of each sound record's case as often as the case says (`repeat`) by `run_again`, of whose record
/// only cost and status count. What the first run took does not count: it was not alone, or found the machine cold. The
/// cases take turns in rounds, every other round in reversed order, so that a slow spell of the machine meets all
/// alike. The geometric mean is kept, and the rounds. The record of a repetition that is not sound replaces that of the
/// first run, and has no cost.
std::vector<records::Record> time_in_rounds(std::vector<records::Record> records,
                                            const std::function<records::Record(const cases::Case&)>& run_again);

}  // namespace mpmvv::runs
