#include <fmt/format.h>

#include "studies/checks/particle_panel.hpp"

namespace mpmvv {

/// W Fig. 2: the square on 8 x 8 cells with four particles each, at three times of a period T.
CheckResult check_square_particles() {
  MovingBody<2> motion({{"problem", "square", ""},
                        {"basis", "cpgimp", ""},
                        {"integrator", "cd", ""},
                        {"boundary", "symmetry", ""},
                        {"cells", "8", ""},
                        {"ppc", "2", ""},
                        {"cfl", "0.4", ""}});
  CheckResult result;
  for (const int eighths : {1, 3, 5}) {
    motion.step_to(motion.resolution().steps * eighths / 8);
    result.series.push_back(particle_panel(eighths == 1 ? "t = T/8" : fmt::format("t = {}T/8", eighths), motion.mpm(),
                                           [](std::uint32_t) { return true; }));
  }
  return result;
}

}  // namespace mpmvv
