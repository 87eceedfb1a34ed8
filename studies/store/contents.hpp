#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace mpmvv::store {

/// What a store holds, by number.
struct Contents {
  /// A program whose records it has.
  struct Program {
    std::string digest, commit;
    bool dirty;
    std::int64_t records;
    std::string last;  ///< time of the newest of them, ISO 8601, UTC
  };

  std::int64_t schema, bytes, studies, records;
  std::int64_t ok, unstable, failed;  ///< of the records
  std::vector<Program> programs;      ///< the one with the newest record first
};

}  // namespace mpmvv::store
