#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Problem cube_in_motion(const char* name, const std::string& source, SetupFunction<3> setup) {
  Problem cube = periodic_body(name, source, setup);
  cube.symmetry_planes = SymmetryPlanes::at_upper_faces;
  return cube;
}

}  // namespace

/// The periodic unit cube, S §5.3. The end time is half a period.
Problem cube_problem() {
  return cube_in_motion("cube", "Steffen et al. 2008, section 5.3",
                        [](const Parameters& p) { return setup_of<3>("cube", p); });
}

/// The cube in motion from rest, for codes that take no initial velocity or deformation. At the end time its
/// displacement is largest.
Problem cube_rest_problem() {
  return cube_in_motion("cube-rest", "as Steffen et al. 2008, section 5.3, from rest",
                        [](const Parameters& p) { return setup_of<3>("cube-rest", p); });
}

}  // namespace mpmvv::problems
