#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// What the quick gate said of sources without a mistake that one compiler and set of flags built. Each run starts its
/// particles in another order and at another place.
struct AlarmCount {
  std::string build;  ///< compiler, optimisation level, processor
  int runs = 0;
  int judged = 0;  ///< goldens judged in all runs
  int alarms = 0;  ///< runs in which a golden did not pass, or none was judged
};

/// What `./run alarms` leaves, to be published.
struct AlarmCounts {
  std::string digest;  ///< of the release program of these sources, see `Provenance`
  std::vector<AlarmCount> builds;
};

/// What such a file holds; nothing where there is none. support::UsageError on every mistake in it, with FILE:LINE.
AlarmCounts read_alarms(const std::filesystem::path& file);

}  // namespace mpmvv::reports
