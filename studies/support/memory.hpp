#pragma once
#include <filesystem>

namespace mpmvv::support {

/// The bytes of memory that a program can have now: what the system has available or, where less, what its control
/// group (version 2) or one around that leaves: Slurm limits a job, while the program is in a group further in. `root`
/// is where /proc and /sys are.
double available_memory(const std::filesystem::path& root = "/");

}  // namespace mpmvv::support
