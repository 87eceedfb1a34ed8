#pragma once
#include <cstdint>
#include <variant>

#include "solver/velocity_update/apic.hpp"
#include "solver/velocity_update/flip.hpp"
#include "solver/velocity_update/fmpm.hpp"
#include "solver/velocity_update/pic.hpp"
#include "solver/velocity_update/xpic.hpp"

namespace mpmvv::solver {

/// The one place where velocity updates are named: add a line here for a new one.
using AnyVelocityUpdate = std::variant<Flip,  //
                                       Xpic,  //
                                       Fmpm,  //
                                       Pic,   //
                                       Apic>;

inline bool adds_accelerations(const AnyVelocityUpdate& update) {
  return std::visit([](const auto& own) { return own.adds_accelerations; }, update);
}
inline bool takes_consistent_mass(const AnyVelocityUpdate& update) {
  return std::visit([](const auto& own) { return own.takes_consistent_mass; }, update);
}
inline bool needs_whole_steps(const AnyVelocityUpdate& update) {
  return std::visit([](const auto& own) { return own.needs_whole_steps(); }, update);
}
inline bool has_affine_field(const AnyVelocityUpdate& update) {
  return std::visit([](const auto& own) { return own.has_affine_field; }, update);
}
inline int expansion_order(const AnyVelocityUpdate& update) {
  return std::visit([](const auto& own) { return own.expansion_order(); }, update);
}
inline bool expands_inverse(const AnyVelocityUpdate& update) {
  return expansion_order(update) > 0;
}
inline bool expands(const AnyVelocityUpdate& update, std::int64_t steps) {
  return std::visit([steps](const auto& own) { return own.expands(steps); }, update);
}
inline bool expands_grid_velocity(const AnyVelocityUpdate& update, std::int64_t steps) {
  return std::visit([steps](const auto& own) { return own.expands_grid_velocity(steps); }, update);
}

}  // namespace mpmvv::solver
