#pragma once
#include <string>

#include "cli/command_text.hpp"

namespace mpmvv::cli {

/// The program's page for `man`, in the macros of man(7).
std::string man_page(const CommandText& program);

}  // namespace mpmvv::cli
