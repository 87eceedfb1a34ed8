#pragma once
#include <span>
#include <string_view>
#include <vector>

namespace mpmvv::solver {

template <int D>
class Step;

/// How a step advances particles and grid, in the order of its equations: a page of sweeps and grid operations, and
/// what it says of itself.
struct Integrator {
  template <int D>
  using Page = void (*)(Step<D>&, double dt);

  std::string_view word;
  Page<1> in_1d;
  Page<2> in_2d;
  Page<3> in_3d;
  bool is_staggered = false;          ///< particle velocities live half a step before the positions
  bool is_remapped = false;           ///< positions move at a rate that particles keep until the step's last sweep
  bool is_staged = false;             ///< keeps states of the particles beside the current one
  bool is_accelerated_first = false;  ///< maps velocities after accelerations: these are no difference of velocities

  template <int D>
  Page<D> page() const {
    if constexpr (D == 1) return in_1d;
    if constexpr (D == 2) return in_2d;
    if constexpr (D == 3) return in_3d;
  }
};

/// All of them, by integrators.cpp.
std::span<const Integrator> integrators();

/// Throws std::invalid_argument on a word that is none's.
const Integrator& integrator_named(std::string_view word);
std::vector<std::string_view> integrator_words();

}  // namespace mpmvv::solver
