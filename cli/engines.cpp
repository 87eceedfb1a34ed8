#include "cli/engines.hpp"

#include <array>

namespace mpmvv::cli {

std::span<const Engine> engines() {
  static constexpr std::array all{Engine{"slurm", "sbatch", slurm_scripts}};
  return all;
}

}  // namespace mpmvv::cli
