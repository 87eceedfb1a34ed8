#pragma once
#include <string>
#include <string_view>

#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// Sets the time or the step of the table if the comment states it: `time = 0.008`, `Time: 0.008 s`, `TIME 0.008`,
/// `t = 0.008`, `step = 32`, alone or first in a part between commas. A time `t` does not count beside one of `time`,
/// and a step has to be a whole number. Throws UsageError, which says the place, for a time in another unit than s.
void note_time(ParticleTable& table, std::string_view comment, const std::string& place);

/// Sets the time of the table if the title of a file states it anywhere, as `time = 0.008`, `Time: 0.008 s` or
/// `t=0.008`. Throws as `note_time`.
void note_time_of_title(ParticleTable& table, std::string_view title, const std::string& place);

}  // namespace mpmvv::codes
