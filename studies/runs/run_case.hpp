#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "solver/boundary/images.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// What a run gives on its way, where it is asked for.
struct Output {
  std::filesystem::path vtu = {};                     ///< folder of the particle states
  std::function<void(std::int64_t)> steps = nullptr;  ///< called now and then with the steps that are done
};

/// Runs one case to its end, or until it blows up. What goes wrong on the way (memory, say) is a record with status
/// `failed`. Apart from the cost, records do not depend on `threads`. A case that asks for its cost goes to
/// `run_timed`, which gives nothing on its way. UsageError when the states cannot be written.
records::Record run_case(const cases::Case& c, int threads, const Output& output = {});

/// The same where the body, its motion, boundary, grid and particles have such images: only the particles of which the
/// others are images are run. The record is the body's but for the cost, which is theirs.
records::Record run_without_images(const cases::Case& c, solver::Images images, int threads,
                                   const std::function<void(std::int64_t)>& tell_steps = nullptr);

/// Runs cases whose cost is measured: on one thread, as often as each says (`repeat`), taking turns. The caller sees to
/// it that nothing else runs on the machine.
std::vector<records::Record> run_timed(const std::vector<cases::Case>& cases);

}  // namespace mpmvv::runs
