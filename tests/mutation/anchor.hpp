#pragma once
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"

namespace mpmvv::mutation {

/// The C++ sources of the program, by their paths from the top of the tree, that an anchor names: the whole path, or
/// its end, from a folder's name on or the file's alone. Tests are no sources of the program.
std::vector<std::string> sources_named(const std::string& file, const std::vector<std::string>& files);

/// Where functions, named lambdas, classes and namespaces of this name are defined: from the name to the closing brace.
std::vector<Region> definitions_of(const std::string& name, const std::string& text);

/// Where a text has the code: its tokens, with any white space and comments between them. Empty where it is no code.
std::vector<Region> occurrences_of(const std::string& code, const std::string& text);

}  // namespace mpmvv::mutation
