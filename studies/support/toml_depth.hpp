#pragma once
#include <string>
#include <string_view>

namespace mpmvv::support {

/// Throws a UsageError, with the line, when a TOML text nests tables and arrays so deeply, by dotted keys or by
/// brackets, that the parser could run out of stack. `name` stands for the file.
void require_shallow(std::string_view text, const std::string& name);

}  // namespace mpmvv::support
