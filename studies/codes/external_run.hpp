#pragma once
#include <filesystem>
#include <mutex>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// Runs one case by another code, in a folder of its own that is removed afterwards unless the run failed, or in
/// `keep`, which stays. A run that goes wrong gives a record with status `failed`, which says where the folder is, or
/// `unstable` where the motion blew up. The time in the record is that of the code's whole process, its start and the
/// reading of its input included, without commands that convert its output. Of a code that chooses its time step the
/// record has no CFL number, and the number of steps that the output states, or 0 where that is unknown.
records::Record run_external(const cases::Case& c, const Code& code, const std::filesystem::path& keep = {});

/// Runs a case whose cost is measured once, by our own solver or by another code.
records::Record run_untimed(const cases::Case& c, const Codes& codes);

/// Measures the cost of cases that have run once, in rounds (rounds.hpp), each in as many as it says (`repeat`). The
/// caller sees to it that nothing else runs on the machine.
std::vector<records::Record> time_in_rounds(std::vector<records::Record> records, const Codes& codes);

/// Kills the programs that run and removes their temporary folders, for a command that is about to stop. No other run
/// begins as long as the lock is held.
[[nodiscard]] std::unique_lock<std::mutex> abandon_external_runs();

}  // namespace mpmvv::codes
