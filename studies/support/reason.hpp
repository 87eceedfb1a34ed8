#pragma once
#include <exception>
#include <string>

namespace mpmvv::support {

/// What an exception says, in one line for a user, whichever library has thrown it.
std::string reason_of(const std::exception& error);

}  // namespace mpmvv::support
