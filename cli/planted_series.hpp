#pragma once
#include <set>
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// The series that another code ran with a planted mistake: a body force that is misplaced or missing where the problem
/// has one. None of a study that this program would not read any more.
std::set<std::string> planted_series(const records::StudyResult& study);

}  // namespace mpmvv::cli
