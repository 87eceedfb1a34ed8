#pragma once
#include <CLI/CLI.hpp>

namespace mpmvv::mutation {

/// The options of the program, and what it does with them.
void add_options(CLI::App& app, int& exit_code);

}  // namespace mpmvv::mutation
