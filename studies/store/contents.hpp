#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "studies/store/version.hpp"

namespace mpmvv::store {

/// What a store holds, in numbers.
struct Contents {
  /// A program whose records it has.
  struct Program {
    std::string digest, commit;
    bool dirty;
    std::int64_t records;
    std::string last;  ///< time of the newest of them, ISO 8601, UTC
  };

  /// Another code that ran studies of it.
  struct Code {
    std::string name;
    std::vector<Version> versions;  ///< by the time of their last study
  };

  std::int64_t schema, bytes, studies, records;
  std::int64_t ok, unstable, failed;  ///< of the records
  std::vector<Program> programs;      ///< the one with the newest record first
  std::vector<Code> codes;            ///< in alphabetical order
};

}  // namespace mpmvv::store
