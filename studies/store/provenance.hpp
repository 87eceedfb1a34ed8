#pragma once
#include <chrono>
#include <string>

namespace mpmvv::store {

/// Where a result comes from. Everything but `cpu` and `time` is fixed by the build.
struct Provenance {
  std::string digest;    ///< of the sources that decide a result, the compiler and its flags
  std::string commit;    ///< git commit of the build, "unknown" outside a checkout
  bool dirty = false;    ///< built from a tree with changes that are not committed
  std::string compiler;  ///< "GNU 12.2.0"
  std::string flags;
  std::string build_type;
  std::string cpu;   ///< model name of the processor
  std::string time;  ///< ISO 8601, UTC
};

/// ISO 8601, UTC, to the second: texts compare as their times do.
std::string time_text(std::chrono::system_clock::time_point time);

/// The provenance of a result that the running program makes now.
Provenance current_provenance();

/// The same with the time of now, for a program that goes on making results.
Provenance with_present_time(Provenance provenance);

}  // namespace mpmvv::store
