#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

/// The periodic bar on [0, 1], S §5.2. The wave speed C is that of the solution; its period is 2/C.
Problem bar_problem() {
  return periodic_body<1>("bar", "Steffen et al. 2008, section 5.2",
                          [](const Parameters& p) { return setup_of<1>("bar", p); });
}

/// From rest: for codes that take no initial velocity and deformation. At the end time it has gone farthest.
Problem bar_rest_problem() {
  return periodic_body<1>("bar-rest", "as Steffen et al. 2008, section 5.2, from rest",
                          [](const Parameters& p) { return setup_of<1>("bar-rest", p); });
}

}  // namespace mpmvv::problems
