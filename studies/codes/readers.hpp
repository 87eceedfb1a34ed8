#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "studies/codes/columns.hpp"
#include "studies/codes/snapshot.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

/// What a reader gets: the whole content of a file, its name for messages, and the step asked for, or none for the
/// last.
struct Source {
  const std::string& content;
  std::string file;
  std::optional<std::int64_t> step = {};
};

/// A file without particles, which a part of a state may be.
struct NoParticles : support::UsageError {
  using UsageError::UsageError;
};

/// A file format. Its reader trusts nothing: it throws UsageError for a file that breaks the format or ends early, and
/// takes no more memory than the size of the file justifies.
struct Format {
  std::string word;
  std::vector<std::string> endings;  ///< file name endings by which the format is recognised: ".csv"
  ParticleTable (*read)(const Source&);
  bool has_steps = false;  ///< whether a file may hold several steps
};

/// Returns all formats. Each has a reader in a file of its own and a line in the list.
const std::vector<Format>& formats();

// The readers, each defined in its own file.
ParticleTable read_csv(const Source& source);
ParticleTable read_vtu(const Source& source);
ParticleTable read_ply(const Source& source);
ParticleTable read_legacy_vtk(const Source& source);
ParticleTable read_dump(const Source& source);
ParticleTable read_nairn(const Source& source);
ParticleTable read_nairn_legacy(const Source& source);

/// Reads a file. `format` is a word of `formats()`; if it is empty, the ending of the name says the format. Throws
/// UsageError if the file cannot be read.
Snapshot read_snapshot(const std::filesystem::path& file, const Columns& columns, const std::string& format = "");

/// Reads several files as one state, of which each process of a parallel code wrote one. Those without particles do not
/// count. Throws UsageError unless the others have the same fields and say the same of time and step.
Snapshot read_snapshot(const std::vector<std::filesystem::path>& parts, const Columns& columns,
                       const std::string& format = "");

}  // namespace mpmvv::codes
