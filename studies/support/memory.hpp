#pragma once
#include <filesystem>

namespace mpmvv::support {

/// The bytes of memory that a program can have now: what the system has available or, in a container with less, what
/// its limit leaves. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

}  // namespace mpmvv::support
