#pragma once
#include <array>
#include <string_view>

#include "solver/integrator/usf.hpp"
#include "solver/integrator/usl.hpp"
#include "solver/integrator/uvf.hpp"

namespace mpmvv::solver {

template <int D>
struct Integrator {
  std::string_view word;
  void (*advance)(Mpm<D>&, double dt);
  bool staggered;  ///< particle velocities live half a step before the positions
};

/// The one place where integrators are named: add a line here for a new one.
template <int D>
inline constexpr std::array integrators{Integrator<D>{"usf", &usf<D>, false},  //
                                        Integrator<D>{"usl", &usl<D>, false},  //
                                        Integrator<D>{"cd", &usl<D>, true},    //
                                        Integrator<D>{"uvf", &uvf<D>, true}};

}  // namespace mpmvv::solver
