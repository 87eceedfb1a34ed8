#pragma once
#include <cstdint>
#include <variant>

#include "solver/velocity_update/apic.hpp"
#include "solver/velocity_update/flip.hpp"
#include "solver/velocity_update/fmpm.hpp"
#include "solver/velocity_update/pic.hpp"
#include "solver/velocity_update/xpic.hpp"

/// What a velocity update must offer, and from the third line on what it may say of itself:
///   word                          its name in study files and on the command line
///   fields(step, dt)              the `VelocityFields`, asked for once the grid's v is that of the step's end
///   adds_accelerations            true when particles keep their velocity and take the grid's acceleration
///   takes_consistent_mass         true when it is defined with the consistent mass, too
///   has_affine_field              true when particles carry the gradient of a velocity field of their own
///   expansion_order()             the terms of the expanded inverse that it takes
///   expands_grid_velocity(steps)  whether, after so many steps, the next one expands the grid velocity itself, that of
///                                 the stress updates, too
namespace mpmvv::solver {

/// The one place where velocity updates are named: add a line here for a new one.
using AnyVelocityUpdate = std::variant<Flip,  //
                                       Xpic,  //
                                       Fmpm,  //
                                       Pic,   //
                                       Apic>;

inline bool adds_accelerations(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U&) {
        return requires {
          U::adds_accelerations;
        };
      },
      update);
}

inline bool takes_consistent_mass(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U&) {
        return requires {
          U::takes_consistent_mass;
        };
      },
      update);
}

inline bool has_affine_field(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U&) {
        return requires {
          U::has_affine_field;
        };
      },
      update);
}

/// 0 for one that takes no expanded inverse.
inline int expansion_order(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U& own) {
        if constexpr (requires { own.expansion_order(); })
          return own.expansion_order();
        else
          return 0;
      },
      update);
}

inline bool expands_inverse(const AnyVelocityUpdate& update) {
  return expansion_order(update) > 0;
}

inline bool expands_grid_velocity(const AnyVelocityUpdate& update, std::int64_t steps) {
  return std::visit(
      [steps]<class U>(const U& own) {
        if constexpr (requires { own.expands_grid_velocity(steps); })
          return own.expands_grid_velocity(steps);
        else
          return false;
      },
      update);
}

}  // namespace mpmvv::solver
