#pragma once
#include <filesystem>
#include <vector>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Runs one case to its end, or until it blows up. What goes wrong on the way (memory, say) is a record with status
/// `failed`. Records do not depend on `threads` but for the cost; a case that asks for its cost is `run_timed`.
/// Particle states of others go to the directory `vtu`, unless it is empty; a UsageError when that cannot be written.
records::Record run_case(const cases::Case& c, int threads, const std::filesystem::path& vtu = {});

/// Runs cases that ask for their cost: on one thread, as often as they say, taking turns; the caller's to run alone.
std::vector<records::Record> run_timed(const std::vector<cases::Case>& cases);

}  // namespace mpmvv::runs
