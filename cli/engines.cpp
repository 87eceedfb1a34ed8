#include "cli/engines.hpp"

#include <array>

namespace mpmvv::cli {

std::span<const Engine> engines() {
  static constexpr std::array all{
      Engine{"slurm", "sbatch", "squeue --me lists what is queued, scancel JOB takes it back", slurm_scripts}};
  return all;
}

}  // namespace mpmvv::cli
