#pragma once
#include <filesystem>
#include <string>

namespace mpmvv::support {

/// Whether this is a file that can be run.
bool is_program(const std::filesystem::path& file);

/// The program of that name on PATH; empty where there is none.
std::filesystem::path program_on_path(const std::string& name);

}  // namespace mpmvv::support
