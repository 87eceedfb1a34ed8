#pragma once
#include <string>
#include <vector>

namespace mpmvv::support {

/// One field of a CSV line, quoted where it has to be. A text that a spreadsheet would carry out as a formula gets an
/// apostrophe in front; numbers stay as they are.
std::string csv_field(const std::string& text);

/// A line of a CSV file, with its end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace mpmvv::support
