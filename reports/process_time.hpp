#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// Says of which of these series, as other codes ran them, the time is that of a whole process; empty without one.
std::string process_time_note(const std::vector<const records::Series*>& series);

}  // namespace mpmvv::reports
