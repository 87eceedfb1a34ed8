#pragma once
#include <string>

namespace mpmvv::support {

/// Kills the processes that have a variable in their environment, with a value or any, and what they start meanwhile:
/// those that a program has started, also where they have left its process group.
void kill_marked(const std::string& variable, const std::string& value = "");

}  // namespace mpmvv::support
