#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "solver/boundary/images.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// What a run puts out on its way, where it is asked for.
struct Output {
  std::filesystem::path vtu = {};                     ///< folder for the particle states; empty: none are written
  std::function<void(std::int64_t)> steps = nullptr;  ///< called now and then with the number of steps done
};

/// Runs one case to its end, or until it blows up. An error on the way (no memory, say) gives a record with status
/// `failed`. Apart from the cost, records do not depend on `threads`. A case that asks for its cost goes to
/// `run_timed`, which uses neither `threads` nor `output`. Throws UsageError when the states cannot be written.
records::Record run_case(const cases::Case& c, int threads, const Output& output = {});

/// Runs a case whose body, motion, boundary, grid and particles have the given images: it runs only the particles of
/// which the others are images. The record is that of the whole body but for the cost, which is that of the particles
/// run.
records::Record run_without_images(const cases::Case& c, solver::Images images, int threads,
                                   const std::function<void(std::int64_t)>& tell_steps = nullptr);

/// Runs cases whose cost is measured: on one thread, as often as each says (`repeat`), taking turns. The caller sees to
/// it that nothing else runs on the machine.
std::vector<records::Record> run_timed(const std::vector<cases::Case>& cases);

}  // namespace mpmvv::runs
