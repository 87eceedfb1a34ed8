#pragma once
#include <vector>

#include "solver/scene.hpp"

/// Boundaries for the properties that all of them have: a new one is among them as soon as it is named.
namespace mpmvv::solver {

/// As the list has them: a wall has no motion yet.
inline std::vector<AnyBoundary> every_boundary() {
  std::vector<AnyBoundary> all;
  const auto add = [&all]<class... Boundaries>(const std::variant<Boundaries...>*) {
    (all.emplace_back(Boundaries{}), ...);
  };
  add(static_cast<const AnyBoundary*>(nullptr));
  return all;
}

inline std::string_view word_of(const AnyBoundary& boundary) {
  return std::visit([]<class B>(const B&) { return B::word; }, boundary);
}

/// Whether it is one that moves, and needs a motion.
inline bool is_moved(const AnyBoundary& boundary) {
  return std::visit(
      [](const auto& own) {
        return requires {
          own.motion;
        };
      },
      boundary);
}

/// A wall that stays where it is.
struct Resting final : WallMotion {
  double place;

  explicit Resting(double x) : place(x) {}
  double position(double) const override { return place; }
  double velocity(double) const override { return 0; }
  double gradient(double) const override { return 0; }
};

/// Ends the unit interval, square or cube so everywhere; what could move rests at its faces.
template <int D>
void end_by(const AnyBoundary& boundary, Scene<D>& scene) {
  static const Resting lower(0), upper(1);
  scene.boundary.fill(boundary);
  for (std::size_t face = 0; face < scene.boundary.size(); ++face)
    std::visit(
        [face](auto& own) {
          if constexpr (requires { own.motion; }) own.motion = face % 2 == 0 ? &lower : &upper;
        },
        scene.boundary[face]);
}

}  // namespace mpmvv::solver
