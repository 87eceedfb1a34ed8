#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

/// The periodic bar on [0, 1], S §5.2. The wave speed is the C of the solution, whose period is 2/C.
Problem bar_problem() {
  return periodic_body<1>("bar", "Steffen et al. 2008, section 5.2",
                          [](const Parameters& p) { return setup_of<1>("bar", p); });
}

/// The bar in motion from rest, for codes that take no initial velocity or deformation. At the end time its
/// displacement is largest.
Problem bar_rest_problem() {
  return periodic_body<1>("bar-rest", "as Steffen et al. 2008, section 5.2, from rest",
                          [](const Parameters& p) { return setup_of<1>("bar-rest", p); });
}

}  // namespace mpmvv::problems
