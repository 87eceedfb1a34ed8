#pragma once
#include <string>

namespace mpmvv::support {

/// Kills the processes that have the variable in their environment, with this value or, if it is empty, with any; and
/// in a few more passes what they start meanwhile. Children inherit the variable, so this also finds those that have
/// left the process group of the program that started them.
void kill_marked(const std::string& variable, const std::string& value = "");

}  // namespace mpmvv::support
