#include "solver/integrator/integrators.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace mpmvv::solver {

Integrator usf_integrator();
Integrator usl_integrator();
Integrator usl_plus_integrator();
Integrator usavg_integrator();
Integrator usavg_plus_integrator();
Integrator cd_integrator();
Integrator uvf_integrator();
Integrator rk4_integrator();

/// The one place where integrators are named: add a line here for a new one, and a declaration above.
std::span<const Integrator> integrators() {
  static const std::array all{usf_integrator(),         //
                              usl_integrator(),         //
                              usavg_integrator(),       //
                              usl_plus_integrator(),    //
                              usavg_plus_integrator(),  //
                              cd_integrator(),          //
                              uvf_integrator(),         //
                              rk4_integrator()};
  return all;
}

const Integrator& integrator_named(std::string_view word) {
  const auto found = std::ranges::find(integrators(), word, &Integrator::word);
  if (found == integrators().end()) throw std::invalid_argument("unknown integrator '" + std::string(word) + "'");
  return *found;
}

std::vector<std::string_view> integrator_words() {
  std::vector<std::string_view> words;
  for (const Integrator& integrator : integrators()) words.push_back(integrator.word);
  return words;
}

}  // namespace mpmvv::solver
