#pragma once
#include <filesystem>
#include <string>

#include "studies/cases/case.hpp"

namespace mpmvv::codes {

/// Returns the case as a JSON object with an end of line: problem, parameters, settings, time step, end time, the
/// columns that an output may have, units. The input of a code is written from it and its output is scored with it.
std::string case_text(const cases::Case& c);

/// Reads a case from such a file. Throws UsageError if it holds none, or if its fields do not agree with each other:
/// they were edited, or make another case now than when the file was written.
cases::Case read_case(const std::filesystem::path& file);

}  // namespace mpmvv::codes
