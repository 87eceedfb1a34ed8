#pragma once
#include <string>

#include "cli/command_text.hpp"

namespace mpmvv::cli {

/// Scripts by which a shell completes commands, options and the words that these take.
std::string bash_completion(const CommandText& program);
std::string zsh_completion(const CommandText& program);
std::string fish_completion(const CommandText& program);

}  // namespace mpmvv::cli
