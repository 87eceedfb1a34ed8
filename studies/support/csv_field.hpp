#pragma once
#include <string>

namespace mpmvv::support {

/// One field of a CSV line, quoted where it has to be. A text that a spreadsheet would carry out as a formula gets an
/// apostrophe in front; numbers stay as they are.
std::string csv_field(const std::string& text);

}  // namespace mpmvv::support
