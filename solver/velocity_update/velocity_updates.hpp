#pragma once
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

inline bool expands_inverse(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U&) {
        return requires(U u) {
          u.order;
        };
      },
      update);
}

}  // namespace mpmvv::solver
