#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"

namespace mpmvv::mutation {

/// Whether `name` names the file at `path`: it is the whole path from the top of the tree, or its end from the name of
/// a folder or of the file on.
bool names(const std::string& name, const std::string& path);

/// The C++ sources of the program among the files of a tree that are so named. Tests are no sources of the program.
std::vector<std::string> sources_named(const std::string& name, const std::vector<std::string>& files);

/// Where functions, named lambdas, classes and namespaces of this name are defined: from the name to the closing brace.
std::vector<Region> definitions_of(const std::string& name, const std::string& text);

/// Whether two pieces of code have the same tokens.
bool is_same_code(const std::string& one, const std::string& other);

/// Where a text has the code: its tokens, with any white space and comments between them. Empty where it is no code.
std::vector<Region> occurrences_of(const std::string& code, const std::string& text);

/// Where a text is most like some code, and how many tokens have to change, be added or go to make it that.
struct Likeness {
  Region region;
  std::size_t differing = 0, tokens = 0;  ///< tokens: of the code
};
Likeness most_like(const std::string& code, const std::string& text);

}  // namespace mpmvv::mutation
