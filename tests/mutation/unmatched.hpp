#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/mutation/mistake.hpp"

namespace mpmvv::mutation {

/// Texts of the program's own sources by their paths from the top of the tree.
using Sources = std::map<std::string, std::string>;
Sources read_sources(const std::filesystem::path& top);

/// An entry of the lists that matches the sources nowhere, or in more than one place.
struct Unmatched {
  std::string complaint;  ///< what is wrong, with FILE:LINE of the entry
  std::string nearest;    ///< the most similar code and its place; empty where there is none like it
};

std::vector<Unmatched> unmatched(const std::vector<Mistake>& mistakes, const std::vector<Explanation>& explanations,
                                 const Sources& sources);

}  // namespace mpmvv::mutation
