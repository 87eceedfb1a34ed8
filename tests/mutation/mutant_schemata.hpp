#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"

namespace mpmvv::mutation {

/// An edit that a program chooses at its start by the number.
struct Choice {
  int number = 0;
  Edit edit;
};

/// Lines, counted from 1, of a statement that stands twice: those with the edit, and the last one of both.
struct ChoicePlace {
  int number = 0, first_line = 0, last_line = 0, last_line_of_both = 0;
};

struct Schemata {
  std::string text;
  std::vector<ChoicePlace> places;  ///< of the choices that are in the text
};

/// A C++ text with several edits side by side: the smallest statement of a block that holds an edit, or the rest of the
/// block where that is a declaration, stands twice, with the edit where its number is chosen and without. For edits
/// within the bodies of functions that are not constexpr; others are left out.
Schemata schemata_of(const std::string& text, const std::vector<Choice>& choices);

/// The header that such texts include, and the environment variable that chooses: at the program's start, so that what
/// runs before, to initialise something static in another file, may see none chosen.
extern const char* const choice_header;
extern const char* const choice_variable;
std::string choice_header_text();

}  // namespace mpmvv::mutation
