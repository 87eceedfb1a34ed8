#pragma once
#include <string>
#include <string_view>

namespace mpmvv::support {

/// The text as one line that neither a terminal nor a log can obey: control characters, marks that turn the direction
/// of writing, separators of lines, and bytes that are not UTF-8 become \n, \t, \r or \xNN.
std::string printable(std::string_view text);

}  // namespace mpmvv::support
