#pragma once
#include <filesystem>

namespace mpmvv::support {

/// The bytes of memory that a program can have now: what the system has available or, where its control group (version
/// 2) has less, what that leaves. `root` is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

}  // namespace mpmvv::support
