#pragma once
#include <optional>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// The record of a case from a run of its part (`settings::part_of`), of which mirror images make the rest. None when
/// the part did not come to its end: that says little of the whole, where round-off does not grow alike on both sides
/// of a plane, so the whole must run.
std::optional<records::Record> run_part(const cases::Case& whole, const cases::Case& part, int threads);

}  // namespace mpmvv::runs
