#include <fmt/format.h>
#include <fmt/ranges.h>

#include "solver/basis/bases.hpp"
#include "solver/boundary/boundaries.hpp"
#include "solver/integrator/words.hpp"
#include "solver/material/materials.hpp"
#include "solver/velocity_update/velocity_updates.hpp"
#include "solver/words.hpp"
#include "studies/settings/settings.hpp"
#include "studies/settings/word_keys.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::Scheme;

namespace {

template <class Words>
std::vector<std::string> strings(const Words& words) {
  return {words.begin(), words.end()};
}

}  // namespace

const std::vector<WordKey>& word_keys() {
  static const std::vector<WordKey> keys{
      {"basis", &Scheme::basis, strings(solver::words<solver::AnyBasis>())},
      {"integrator", &Scheme::integrator, strings(solver::integrator_words())},
      {"start", &Scheme::start, {"half", "exact"}},
      {"velocity_update", &Scheme::velocity_update, strings(solver::words<solver::AnyVelocityUpdate>())},
      {"position", &Scheme::position, {"first-order", "second-order", "particle"}},
      {"wall_method", &Scheme::wall_method, {"velocity", "lumped", "combined", "elimination"}},
      {"wall_gradient", &Scheme::wall_gradient, {"zero", "given", "estimated"}},
      {"mass", &Scheme::mass, {"lumped", "consistent"}},
      {"wall_acceleration", &Scheme::wall_acceleration, {"zero", "difference"}},
      {"deformation", &Scheme::deformation, {"linear", "exponential"}},
      {"body_force", &Scheme::body_force, {"particles", "grid"}},
      {"fill", &Scheme::fill, {"lattice", "conforming"}},
      {"material", &Scheme::material, strings(solver::words<solver::AnyMaterial>())},
  };
  return keys;
}

const std::vector<SettingKey>& setting_keys() {
  static const std::vector<SettingKey> keys{
      {"problem", "what is solved"},
      {"quarter", "only the part where no coordinate is negative", true},
      {"basis", "grid basis functions"},
      {"smoothing_length", "of ugimp, in cells"},
      {"integrator", "order of the step"},
      {"start", "first step of cd and uvf"},
      {"velocity_update", "how particle velocities follow the grid"},
      {"order", "terms k of xpic and fmpm"},
      {"cfl_x", "as cfl, of the steps that fmpm takes; flip between them"},
      {"position", "how particle positions follow the grid with flip"},
      {"wall_method", "how walls hold what xpic and fmpm expand"},
      {"wall_depth", "cells inside a moving wall that it holds (1)"},
      {"wall_gradient", "of the velocity that a moving wall holds (given)"},
      {"mass", "mass matrix"},
      {"boundary", "all faces, or per face as xmin=symmetry,xmax=free"},
      {"wall_acceleration", "acceleration of held nodes"},
      {"deformation", "update of F"},
      {"body_force", "where the body force is evaluated"},
      {"fill", "how particles fill the body"},
      {"material", "constitutive law"},
      {"cells", "cells per length L of the problem"},
      {"ppc", "particles per cell and direction"},
      {"grid_offset", "shift of the grid against the body where nothing holds it, in cells"},
      {"shuffle", "seed of another order of the particles"},
      {"cfl", "wave speed times time step over cell width"},
      {"dt", "time step in s; must divide the end time"},
      {"end_time", "in s"},
      {"steps", "stop after so many steps of the default end time's step"},
      {"every_step", "errors over all steps, too", true},
      {"nodal_error", "error of the nodal accelerations at the end, too", true},
      {"velocity_error", "mean over all steps of the RMS velocity error, too", true},
      {"stress_error", "RMS error of the stresses at the end, too", true},
      {"blowup_error", "unstable beyond this error, in displacement amplitudes"},
      {"blowup_energy", "unstable beyond this energy, in initial energies"},
      {"repeat", "run alone so often (3 or more) and keep the median cost"},
  };
  return keys;
}

std::vector<std::string> words_of_key(const std::string& key) {
  if (key == "boundary") return strings(solver::words<solver::AnyBoundary>());
  for (const WordKey& word_key : word_keys())
    if (word_key.key == key) return word_key.words;
  return {};
}

void require_known_key(const std::string& key, const std::string& where) {
  if (key.starts_with("param.")) return;
  std::vector<std::string> known;
  for (const SettingKey& k : setting_keys()) {
    if (k.key == key) return;
    known.push_back(k.key);
  }
  throw support::UsageError(
      fmt::format("unknown key '{}' in {} (known: {}, param)", key, where, fmt::join(known, ", ")));
}

}  // namespace mpmvv::settings
