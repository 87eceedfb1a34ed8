#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// A run of the quick gate on sources without a mistake, with another order and place of the particles.
struct AlarmRun {
  std::string build;                         ///< compiler, optimisation level, processor
  int pass = 0, fail = 0, inconclusive = 0;  ///< goldens

  /// One that judges nothing has failed, too.
  bool is_alarm() const { return pass == 0 || fail > 0 || inconclusive > 0; }
};

/// What `./run alarms` publishes.
struct AlarmLog {
  std::string digest;  ///< of the release program of these sources, see `Provenance`
  std::vector<AlarmRun> runs;
};

/// What such a file holds; nothing where there is none. support::UsageError on every mistake in it, with FILE:LINE.
AlarmLog read_alarms(const std::filesystem::path& file);

}  // namespace mpmvv::reports
