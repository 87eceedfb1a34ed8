#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tests/mutation/edit.hpp"

namespace mpmvv::mutation {

/// Every operator mutation of a C++ text, in its order: + and -, * and / exchanged, also in assignments; a unary minus
/// dropped; a comparison changed; an index set to 0 or exchanged with its neighbour's; a number changed; true and false
/// exchanged. What does not compile is among them.
std::vector<Edit> mutations_of(const std::string& file, const std::string& text);

/// The edits in an order that the seed alone decides, on every machine.
std::vector<Edit> shuffled(std::vector<Edit> edits, std::uint64_t seed);

/// The files of a tree that random mutations are drawn from, sorted: the code of the folders that compute.
std::vector<std::string> mutated_files(const std::vector<std::string>& files);

}  // namespace mpmvv::mutation
