#pragma once
#include <span>
#include <string_view>
#include <vector>

namespace mpmvv::solver {

template <int D>
class Step;

/// A time integrator: its word, its page, and its properties. The page is a function that makes a step, as sweeps and
/// grid operations in the order of the equations.
struct Integrator {
  template <int D>
  using Page = void (*)(Step<D>&, double dt);

  std::string_view word;
  Page<1> in_1d;
  Page<2> in_2d;
  Page<3> in_3d;
  bool is_staggered = false;          ///< particle velocities are half a step behind the positions
  bool is_remapped = false;           ///< positions move in the step's last sweep, at a rate that particles have kept
  bool is_staged = false;             ///< keeps states of the particles beside the current one
  bool is_accelerated_first = false;  ///< finds a_i before v_i: it cannot be a difference of velocities, S (30)
  double share_after_stress = 1;      ///< how much of the step is still to come for F when the stress is evaluated

  /// Whether particles take any velocity update. The velocities of a staggered integrator are half a step behind the
  /// positions, and one with stages writes them itself.
  bool has_whole_steps() const { return !is_staggered && !is_staged; }

  template <int D>
  Page<D> page() const {
    if constexpr (D == 1) return in_1d;
    if constexpr (D == 2) return in_2d;
    if constexpr (D == 3) return in_3d;
  }
};

/// Returns all integrators, listed in integrators.cpp.
std::span<const Integrator> integrators();

/// Returns the integrator with this word. Throws std::invalid_argument when there is none.
const Integrator& integrator_named(std::string_view word);
std::vector<std::string_view> integrator_words();

}  // namespace mpmvv::solver
