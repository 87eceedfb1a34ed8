#pragma once
#include <string>

namespace mpmvv::goldens {

/// What a gate says of one golden. `inconclusive`: the store has no result that could pass or fail it.
enum class Verdict { pass, fail, inconclusive };

inline std::string to_string(Verdict v) {
  switch (v) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::inconclusive:
      break;
  }
  return "inconclusive";
}

}  // namespace mpmvv::goldens
