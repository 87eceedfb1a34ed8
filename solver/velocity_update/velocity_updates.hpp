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

/// How many terms of the expanded inverse it takes; 0 when it takes none.
inline int expansion_order(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U& u) {
        if constexpr (requires { u.order; })
          return u.order;
        else
          return 0;
      },
      update);
}

inline bool expands_inverse(const AnyVelocityUpdate& update) {
  return expansion_order(update) > 0;
}

}  // namespace mpmvv::solver
