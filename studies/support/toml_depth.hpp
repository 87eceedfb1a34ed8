#pragma once
#include <string>
#include <string_view>

namespace mpmvv::support {

/// UsageError with the line where a TOML text nests its tables and arrays so deeply, by dotted keys or by brackets,
/// that reading it takes more stack than there is. `name` stands for the file.
void require_shallow(std::string_view text, const std::string& name);

}  // namespace mpmvv::support
