#pragma once
#include <array>

#include "studies/support/words.hpp"

namespace mpmvv::records {

using support::to_string;

/// A gate's verdict on one golden. `inconclusive`: the store has no result that could pass or fail it.
enum class Verdict { pass, fail, inconclusive };
constexpr std::array<const char*, 3> words_of(Verdict) {
  return {"pass", "fail", "inconclusive"};
}

}  // namespace mpmvv::records
