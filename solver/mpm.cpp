#include "solver/mpm_impl.hpp"

namespace mpmvv::solver {

template class Mpm<1>;  // the other dimensions have files of their own, compiled beside this one

std::vector<std::string_view> integrator_words() {
  std::vector<std::string_view> words;
  for (const auto& integrator : integrators<1>) words.push_back(integrator.word);
  return words;
}

bool is_staggered(std::string_view word) {
  for (const auto& integrator : integrators<1>)
    if (integrator.word == word) return integrator.staggered;
  return false;
}

}  // namespace mpmvv::solver
