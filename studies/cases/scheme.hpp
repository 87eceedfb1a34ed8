#pragma once
#include <array>
#include <compare>
#include <string>

#include "studies/support/words.hpp"

namespace mpmvv::cases {

using support::to_string;

// docs/theory.md says what each word means. `none` stands in a scheme that has no such choice; a user can give it only
// for ForceForm.

/// The first step of a staggered integrator.
enum class Start { half, exact, none };
constexpr std::array<const char*, 3> words_of(Start) {
  return {"half", "exact", "none"};
}

/// How particle positions follow the grid with FLIP.
enum class Position { first_order, second_order, particle, none };
constexpr std::array<const char*, 4> words_of(Position) {
  return {"first-order", "second-order", "particle", "none"};
}

/// Which velocities walls hold when an expanded inverse is applied.
enum class WallMethod { velocity, lumped, combined, elimination, none };
constexpr std::array<const char*, 5> words_of(WallMethod) {
  return {"velocity", "lumped", "combined", "elimination", "none"};
}

/// Where the gradient of the velocity that a moving wall holds comes from.
enum class WallGradient { zero, given, estimated, none };
constexpr std::array<const char*, 4> words_of(WallGradient) {
  return {"zero", "given", "estimated", "none"};
}

/// The matrix of the nodes' masses.
enum class Mass { lumped, consistent };
constexpr std::array<const char*, 2> words_of(Mass) {
  return {"lumped", "consistent"};
}

/// The acceleration of held nodes.
enum class WallAcceleration { zero, difference };
constexpr std::array<const char*, 2> words_of(WallAcceleration) {
  return {"zero", "difference"};
}

/// How F' follows from F and L.
enum class Deformation { linear, exponential };
constexpr std::array<const char*, 2> words_of(Deformation) {
  return {"linear", "exponential"};
}

/// Where the body force is evaluated.
enum class BodyForce { particles, grid };
constexpr std::array<const char*, 2> words_of(BodyForce) {
  return {"particles", "grid"};
}

/// How particles fill the body.
enum class Fill { lattice, conforming };
constexpr std::array<const char*, 2> words_of(Fill) {
  return {"lattice", "conforming"};
}

/// How the body force reaches another code. Two words are planted mistakes: `misplaced`, b(X) with x in the place of X,
/// and `none`, no body force at all.
enum class ForceForm { reference, current, inverse, per_particle, misplaced, none };
constexpr std::array<const char*, 6> words_of(ForceForm) {
  return {"reference", "current", "inverse", "per-particle", "misplaced", "none"};
}

/// How a problem is solved. Words from the solver's lists are strings, because this room does not include the solver.
struct Scheme {
  std::string basis = "linear";
  double smoothing_length = 0;  ///< in cells; only for `ugimp`, 0 elsewhere
  std::string integrator = "usl";
  Start start = Start::half;
  std::string velocity_update = "flip";
  int order = 0;                              ///< k of `xpic` and `fmpm`; 0 elsewhere, and with the consistent mass
  double cfl_x = 0;                           ///< CFL number of the steps of periodic `fmpm`; 0: it takes every step
  Position position = Position::first_order;  ///< `none` where the velocity update has its own way
  WallMethod wall_method = WallMethod::none;  ///< `none` where no inverse is expanded
  double wall_depth = 0;                      ///< number of cells inside a moving wall that it holds; 0 without one
  WallGradient wall_gradient = WallGradient::none;
  Mass mass = Mass::lumped;
  std::string boundary = "dirichlet";
  WallAcceleration wall_acceleration = WallAcceleration::zero;
  Deformation deformation = Deformation::linear;
  BodyForce body_force = BodyForce::particles;
  Fill fill = Fill::lattice;
  std::string material = "neo-hookean-log";

  /// The code that solves it; empty: our own solver. With another code, settings of our own solver have no meaning.
  std::string code = {};
  std::string variant = {};  ///< variant of the code, a word of its adapter
  ForceForm force_form = ForceForm::reference;
  std::string code_version = {};  ///< version that its program prints, or digest of its file
  std::string adapter = {};       ///< digest of the files of the adapter and of the program

  auto operator<=>(const Scheme&) const = default;
};

}  // namespace mpmvv::cases
