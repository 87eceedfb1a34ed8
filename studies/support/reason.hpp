#pragma once
#include <exception>
#include <string>

namespace mpmvv::support {

/// What went wrong, in one line for a user, whoever has thrown it.
std::string reason_of(const std::exception& error);

}  // namespace mpmvv::support
