#pragma once
#include <string>
#include <vector>

#include "studies/cases/scheme.hpp"

namespace mpmvv::settings {

/// Key and member of Scheme that take one of a few words.
struct WordKey {
  std::string key;
  std::string Scheme::*member;
  std::vector<std::string> words;
};

const std::vector<WordKey>& word_keys();

}  // namespace mpmvv::settings
