#include <fmt/format.h>

#include <stdexcept>

#include "studies/checks/profiles/particle_panel.hpp"

namespace mpmvv::checks {

namespace {

/// A moment of a run as a fraction of its end time, and how a figure names it.
struct Moment {
  const char* name;
  int eighths;
};

CheckResult particles_at(const std::vector<Moment>& moments, const std::vector<settings::Setting>& settings) {
  profiles::MovingBody<2> motion(settings);
  CheckResult result;
  const std::int64_t steps = motion.resolution().steps;
  if (steps % 8 != 0) throw std::logic_error(fmt::format("pictures of a run of {} steps (a multiple of 8)", steps));
  for (const auto& [name, eighths] : moments) {
    motion.step_to(steps / 8 * eighths);
    result.series.push_back(profiles::particle_panel(name, motion.mpm(), [](std::uint32_t) { return true; }));
  }
  return result;
}

}  // namespace

/// Returns the particles of W Fig. 2: the square on 8 x 8 cells with four particles each, at three times of a period T.
CheckResult check_square_particles() {
  return particles_at({{"t = T/8", 1}, {"t = 3T/8", 3}, {"t = 5T/8", 5}}, {{"problem", "square", ""},
                                                                           {"basis", "cpgimp", ""},
                                                                           {"integrator", "cd", ""},
                                                                           {"boundary", "symmetry", ""},
                                                                           {"cells", "8", ""},
                                                                           {"ppc", "2", ""},
                                                                           {"cfl", "0.4", ""}});
}

/// Returns the particles of W Fig. 5: the ring at three times of a period T, from its widest to its narrowest.
CheckResult check_ring_particles() {
  return particles_at({{"t = 0", 0}, {"t = T/4", 2}, {"t = T/2", 4}}, {{"problem", "ring", ""},
                                                                       {"quarter", "true", ""},
                                                                       {"basis", "cpgimp", ""},
                                                                       {"integrator", "cd", ""},
                                                                       {"cells", "8", ""},
                                                                       {"ppc", "2", ""},
                                                                       {"cfl", "0.4", ""}});
}

/// Returns the particles of the ring of claim X-ring, which lie in rows along the surfaces.
CheckResult check_ring_rows() {
  return particles_at({{"t = 0", 0}, {"t = T/4", 2}, {"t = T/2", 4}}, {{"problem", "ring", ""},
                                                                       {"quarter", "true", ""},
                                                                       {"basis", "bspline3", ""},
                                                                       {"integrator", "cd", ""},
                                                                       {"fill", "conforming", ""},
                                                                       {"cells", "8", ""},
                                                                       {"ppc", "2", ""},
                                                                       {"cfl", "0.2", ""}});
}

/// Returns the particles of the vortex at the start, on their way out and at their farthest. 80 steps, CFL 0.19.
CheckResult check_vortex_particles() {
  return particles_at({{"t = 0", 0}, {"t = 1/8", 1}, {"t = 1/2", 4}}, {{"problem", "vortex", ""},
                                                                       {"basis", "bspline3", ""},
                                                                       {"integrator", "cd", ""},
                                                                       {"fill", "conforming", ""},
                                                                       {"cells", "16", ""},
                                                                       {"ppc", "2", ""},
                                                                       {"dt", "0.0125", ""}});
}

}  // namespace mpmvv::checks
