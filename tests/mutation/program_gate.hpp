#pragma once
#include <string>
#include <vector>

#include "tests/mutation/scratch_tree.hpp"

namespace mpmvv::mutation {

/// The parts of the tree that a scratch copy of the program needs.
std::vector<std::string> program_parts();

/// Two digests of what decides how a mutant fares, with a slash between them: that of the sources, and that of the
/// tests, goldens, study files and reports. Where only the second differs, only what passed is tried again.
std::string gate_version(const ScratchTree& tree);

/// The names of the studies in a list such as studies/quick.txt.
std::vector<std::string> listed_studies(const std::string& text);

/// The studies that have goldens, by the goldens' files.
std::vector<std::string> studies_with_goldens(const std::vector<std::string>& files);

/// Whether the verdict of one of our own goldens can depend on this file. It cannot on the report's, of which `mpmvv
/// study` and `mpmvv gate` take only texts, on those of the C interface, and on those that run other codes.
bool decides_the_gate(const std::string& file);

/// The test programs that a change of this file reaches; all for an empty name. Those of its own folder come first:
/// most mistakes are caught there.
std::vector<std::string> test_programs(const std::string& file);

}  // namespace mpmvv::mutation
