#pragma once
#include <functional>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// The records of cases whose cost is measured. Each sound run is repeated as often as its case says (`repeat`), in
/// rounds, so that a slow spell of the machine meets all alike; of the times the median is kept.
std::vector<records::Record> run_in_rounds(const std::vector<cases::Case>& cases,
                                           const std::function<records::Record(const cases::Case&)>& run);

}  // namespace mpmvv::runs
