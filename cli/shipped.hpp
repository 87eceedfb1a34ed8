#pragma once
#include <filesystem>
#include <string>

namespace mpmvv::cli {

/// The folder `studies` or `goldens` that comes with the program: PREFIX/share/mpmvv/... of a program in PREFIX/bin,
/// else that of the tree in which it was built. Empty where neither is there.
std::filesystem::path shipped(const std::string& folder);

}  // namespace mpmvv::cli
