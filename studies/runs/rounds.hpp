#pragma once
#include <functional>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Runs cases whose cost is measured and returns their records. The cost of each sound run is measured as often as its
/// case says (`repeat`), in ns per particle and step: first with the run, then by `cost_of`. The cases take turns in
/// rounds, so that a slow spell of the machine meets all alike. The median is kept.
std::vector<records::Record> run_in_rounds(const std::vector<cases::Case>& cases,
                                           const std::function<records::Record(const cases::Case&)>& run,
                                           const std::function<double(const cases::Case&)>& cost_of);

}  // namespace mpmvv::runs
