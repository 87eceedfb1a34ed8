#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace mpmvv::cli {

/// Gives a program its commands and options, with callbacks that do the work and set the exit code.
using AddCommands = std::function<void(CLI::App& app, int& exit_code)>;

/// Runs one of the project's programs and returns its exit code. Bad input, and all else that is thrown, gets one line
/// on standard error and exit code 2.
int enter(int argc, char** argv, const std::string& name, const std::string& description, const AddCommands& add);

}  // namespace mpmvv::cli
