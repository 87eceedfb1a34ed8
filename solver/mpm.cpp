#include "solver/mpm_impl.hpp"

namespace mpmvv::solver {

template class ConsistentMass<1>;
template class Mpm<1>;  // the other dimensions have files of their own, compiled beside this one

std::vector<std::string_view> integrator_words() {
  std::vector<std::string_view> words;
  for (const auto& integrator : integrators<1>) words.push_back(integrator.word);
  return words;
}

bool is_staggered(std::string_view word) {
  return detail::find_integrator<1>(word).kind == IntegratorKind::staggered;
}

bool is_staged(std::string_view word) {
  return detail::find_integrator<1>(word).kind == IntegratorKind::staged;
}

}  // namespace mpmvv::solver
