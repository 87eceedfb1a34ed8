#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::support {

/// How many letters must be added, removed, replaced or swapped with their neighbours to turn one word into the other
/// (Damerau-Levenshtein, no letter touched twice). Case is ignored.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The known word that was probably meant: the nearest one, if at most a third of the letters (but one at least)
/// differ; else nullopt.
std::optional<std::string> nearest_word(const std::string& word, const std::vector<std::string>& known);

/// Messages of the form "unknown KIND 'WORD' in PLACE (known: A, B)", whoever made them, also say which of the known
/// words is probably meant, and of a long list only the nearest words; others stay as they are.
std::string with_suggestion(const std::string& message);

}  // namespace mpmvv::support
