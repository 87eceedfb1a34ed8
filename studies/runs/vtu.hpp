#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/mpm.hpp"

namespace mpmvv::runs {

/// Particle states as VTK files for ParaView: DIR/particles-0000.vtu, ... and DIR/particles.pvd, which lists them with
/// their times. Fields: id (from 1 on; the order of particles changes from state to state), displacement, velocity,
/// deformation_gradient (row by row), mass. ASCII, 17 digits.
class VtuSeries {
 public:
  static constexpr std::int64_t frames = 10;  ///< number of states written after the first one, at most

  /// Makes the directory. Throws UsageError when it cannot be made.
  explicit VtuSeries(std::filesystem::path dir);

  /// Whether the state after `step` of `steps` steps is one of the frames.
  static bool due(std::int64_t step, std::int64_t steps) {
    return step * frames / steps != (step - 1) * frames / steps;
  }

  /// Writes the present state. The first call removes the files of an earlier series. `X` holds the reference positions
  /// by particle id. Throws WriteError, a UsageError, when a file cannot be written.
  template <int D>
  void write(const solver::Mpm<D>& mpm, const std::vector<solver::Vec<D>>& X);

 private:
  void remove_earlier() const;

  std::filesystem::path dir_;
  std::string entries_;  ///< the lines of particles.pvd that list the states
  int count_ = 0;
};

}  // namespace mpmvv::runs
