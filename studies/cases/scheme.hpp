#pragma once
#include <array>
#include <compare>
#include <string>

#include "studies/support/words.hpp"

namespace mpmvv::cases {

using support::to_string;

// What each word means: docs/theory.md. `none`, which nobody can ask for, is of a scheme that has no such choice.

/// First step of a staggered integrator.
enum class Start { half, exact, none };
constexpr std::array<const char*, 3> words_of(Start) {
  return {"half", "exact", "none"};
}

/// How positions follow FLIP.
enum class Position { first_order, second_order, particle, none };
constexpr std::array<const char*, 4> words_of(Position) {
  return {"first-order", "second-order", "particle", "none"};
}

/// How walls hold what an expanded inverse gives.
enum class WallMethod { velocity, lumped, combined, elimination, none };
constexpr std::array<const char*, 5> words_of(WallMethod) {
  return {"velocity", "lumped", "combined", "elimination", "none"};
}

/// Of the velocity that a moving wall holds.
enum class WallGradient { zero, given, estimated, none };
constexpr std::array<const char*, 4> words_of(WallGradient) {
  return {"zero", "given", "estimated", "none"};
}

/// The matrix of the nodes' masses.
enum class Mass { lumped, consistent };
constexpr std::array<const char*, 2> words_of(Mass) {
  return {"lumped", "consistent"};
}

/// Of held nodes.
enum class WallAcceleration { zero, difference };
constexpr std::array<const char*, 2> words_of(WallAcceleration) {
  return {"zero", "difference"};
}

/// F' from F and L.
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

/// How the body force reaches another code. `misplaced` is b(X) taken at x, a planted mistake; so is `none`, no b at
/// all.
enum class ForceForm { reference, current, inverse, per_particle, misplaced, none };
constexpr std::array<const char*, 6> words_of(ForceForm) {
  return {"reference", "current", "inverse", "per-particle", "misplaced", "none"};
}

/// How a problem is solved. Words of the solver's own lists are texts here, which does not know it.
struct Scheme {
  std::string basis = "linear";
  double smoothing_length = 0;  ///< in cells; only for `ugimp`, 0 elsewhere
  std::string integrator = "usl";
  Start start = Start::half;
  std::string velocity_update = "flip";
  int order = 0;                              ///< k of `xpic` and `fmpm`, 0 elsewhere
  double cfl_x = 0;                           ///< CFL number of `fmpm`'s own steps; 0: every one
  Position position = Position::first_order;  ///< `none` where the update has a way of its own
  WallMethod wall_method = WallMethod::none;  ///< `none` where nothing is expanded
  double wall_depth = 0;                      ///< cells inside a moving wall that it holds; 0 without one
  WallGradient wall_gradient = WallGradient::none;
  Mass mass = Mass::lumped;
  std::string boundary = "dirichlet";
  WallAcceleration wall_acceleration = WallAcceleration::zero;
  Deformation deformation = Deformation::linear;
  BodyForce body_force = BodyForce::particles;
  Fill fill = Fill::lattice;
  std::string material = "neo-hookean-log";

  /// The code that solves it; empty: our own. With another code the words of our own solver say nothing.
  std::string code = {};
  std::string variant = {};  ///< of the code, a word of its adapter
  ForceForm force_form = ForceForm::reference;
  std::string code_version = {};  ///< that its program gives, or its file's digest
  std::string adapter = {};       ///< digest of the adapter's files

  auto operator<=>(const Scheme&) const = default;
};

}  // namespace mpmvv::cases
