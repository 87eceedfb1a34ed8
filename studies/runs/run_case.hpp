#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

#include "solver/boundary/images.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// What a run puts out on its way, where it is asked for.
struct Output {
  std::filesystem::path vtu = {};                     ///< folder for the particle states; empty: none are written
  std::function<void(std::int64_t)> steps = nullptr;  ///< called now and then with the number of steps done
};

/// Runs one case to its end, or until it blows up. An error on the way (no memory, say) gives a record with status
/// `failed`. Apart from the cost, records do not depend on `threads`. A case that asks for its cost
/// is run in rounds (rounds.hpp) of its own, and neither `threads` nor `output` is used. Throws UsageError when the
/// states cannot be written.
records::Record run_case(const cases::Case& c, int threads, const Output& output = {});

/// Runs a case whose body, motion, boundary, grid and particles have the given images: it runs only the particles of
/// which the others are images. The record is that of the whole body but for the cost, which is that of the particles
/// run.
records::Record run_without_images(const cases::Case& c, solver::Images images, int threads,
                                   const std::function<void(std::int64_t)>& tell_steps = nullptr);

/// For rounds: runs a case on one thread, whether it asks for its cost or not; and runs its steps once more, with
/// nothing else in between, for a record with their cost alone.
records::Record run_untimed(const cases::Case& c);
records::Record time_steps(const cases::Case& c);

}  // namespace mpmvv::runs
