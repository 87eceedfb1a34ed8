#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

/// What an option's value has to be, with messages like those of settings.
namespace mpmvv::cli {

CLI::Validator one_of(const std::vector<std::string>& words);
std::string word_of(const std::vector<std::string>& words);     ///< a type's name by which completions know its words
CLI::Validator from_to(std::int64_t least, std::int64_t most);  ///< a whole number

}  // namespace mpmvv::cli
