#pragma once
#include <filesystem>
#include <mutex>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// Runs one case by another code, in a folder of its own that is removed afterwards unless the run failed, or in
/// `keep`, which stays. What goes wrong on the way is a record with status `failed`, which says where the folder is.
/// The time is that of the whole process, start and input included.
records::Record run_external(const cases::Case& c, const Code& code, const std::filesystem::path& keep = {});

/// Runs of which the cost is measured: as often as each says (`repeat`), taking turns, and the median taken.
std::vector<records::Record> run_external_timed(const std::vector<cases::Case>& cases, const Codes& codes);

/// Ends the programs that run and removes their folders: for a command that is about to stop. As long as the lock is
/// held, no other run begins.
[[nodiscard]] std::unique_lock<std::mutex> abandon_external_runs();

}  // namespace mpmvv::codes
