#pragma once
#include <array>
#include <string_view>

#include "solver/integrator/rk4.hpp"
#include "solver/integrator/usavg.hpp"
#include "solver/integrator/usavg_plus.hpp"
#include "solver/integrator/usf.hpp"
#include "solver/integrator/usl.hpp"
#include "solver/integrator/usl_plus.hpp"
#include "solver/integrator/uvf.hpp"
#include "solver/integrator/words.hpp"

namespace mpmvv::solver {

enum class IntegratorKind {
  plain,
  staggered,  ///< particle velocities live half a step before the positions
  remapped,   ///< the last stress update takes a velocity mapped anew, before positions move
  staged      ///< keeps states of the particles beside the current one
};

template <int D>
struct Integrator {
  std::string_view word;
  void (*advance)(Mpm<D>&, double dt);
  IntegratorKind kind = IntegratorKind::plain;
};

/// The one place where integrators are named: add a line here for a new one.
template <int D>
inline constexpr std::array integrators{Integrator<D>{"usf", &usf<D>},                                      //
                                        Integrator<D>{"usl", &usl<D>},                                      //
                                        Integrator<D>{"usavg", &usavg<D>},                                  //
                                        Integrator<D>{"usl+", &usl_plus<D>, IntegratorKind::remapped},      //
                                        Integrator<D>{"usavg+", &usavg_plus<D>, IntegratorKind::remapped},  //
                                        Integrator<D>{"cd", &usl<D>, IntegratorKind::staggered},            //
                                        Integrator<D>{"uvf", &uvf<D>, IntegratorKind::staggered},           //
                                        Integrator<D>{"rk4", &rk4<D>, IntegratorKind::staged}};

}  // namespace mpmvv::solver
