#pragma once
#include <string>
#include <vector>

#include "studies/cases/scheme.hpp"

namespace mpmvv::settings {

/// A key whose words come from a list of the solver.
struct SolverWords {
  std::string key;
  std::string cases::Scheme::*member;
  std::vector<std::string> words;
};

/// Returns all such keys but `boundary`, which may have a word for each face.
const std::vector<SolverWords>& solver_words();

template <class Words>
std::vector<std::string> strings(const Words& words) {
  return {words.begin(), words.end()};
}

}  // namespace mpmvv::settings
