#include "studies/settings/solver_words.hpp"

#include "solver/basis/bases.hpp"
#include "solver/integrator/integrators.hpp"
#include "solver/material/materials.hpp"
#include "solver/velocity_update/velocity_updates.hpp"
#include "solver/words.hpp"

namespace mpmvv::settings {

using cases::Scheme;

const std::vector<SolverWords>& solver_words() {
  static const std::vector<SolverWords> lists{
      {"basis", &Scheme::basis, strings(solver::words<solver::AnyBasis>())},
      {"integrator", &Scheme::integrator, strings(solver::integrator_words())},
      {"velocity_update", &Scheme::velocity_update, strings(solver::words<solver::AnyVelocityUpdate>())},
      {"material", &Scheme::material, strings(solver::words<solver::AnyMaterial>())}};
  return lists;
}

}  // namespace mpmvv::settings
