#pragma once
#include <string>
#include <string_view>

namespace mpmvv::support {

/// The text as one line that a terminal or a log takes for nothing but text: control characters, what turns the
/// direction of writing or breaks a line, and bytes that are not UTF-8 become \n, \t, \r or \xNN.
std::string printable(std::string_view text);

}  // namespace mpmvv::support
