#pragma once
#include <string>

#include "tests/mutation/mistake.hpp"
#include "tests/mutation/score.hpp"

namespace mpmvv::mutation {

/// Texts for a terminal of 100 columns.
std::string text_of(const Mistake& mistake);
std::string text_of(const Score& score);

}  // namespace mpmvv::mutation
