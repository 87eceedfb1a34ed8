#pragma once
#include <string>

namespace mpmvv::support {

/// The text in single quotes, which a shell takes for one word as it stands.
std::string shell_quoted(const std::string& text);

/// The same where a shell would take the text apart or change it; else the text alone.
std::string shell_word(const std::string& text);

}  // namespace mpmvv::support
