#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include "studies/records/record.hpp"
#include "studies/settings/part.hpp"

namespace mpmvv::runs {

/// Returns the record of a case from a run of its part (`settings::part_of`), of which images make the rest. Returns
/// none when the part did not come to its end. This says little of the whole, where round-off does not grow alike in
/// all images, so the whole must be run.
std::optional<records::Record> run_part(const cases::Case& whole, const settings::Part& part, int threads,
                                        const std::function<void(std::int64_t)>& tell_steps = nullptr);

}  // namespace mpmvv::runs
