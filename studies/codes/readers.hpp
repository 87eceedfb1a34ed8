#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "studies/codes/columns.hpp"
#include "studies/codes/snapshot.hpp"

namespace mpmvv::codes {

/// What a reader is given: the whole content of a file, its name for messages, and which step is asked for.
struct Source {
  const std::string& content;
  std::string file;
  std::optional<std::int64_t> step = {};
};

/// A kind of file. A reader trusts nothing: what is not as the format says, or ends early, is a UsageError, and no
/// memory is taken that the size of the file does not bear out.
struct Format {
  std::string word;
  std::vector<std::string> endings;  ///< of names, by which it is known: ".csv"
  ParticleTable (*read)(const Source&);
  bool has_steps = false;  ///< whether a file may hold several
};

/// All formats: a reader's file and a line here for each.
const std::vector<Format>& formats();

// The readers, each defined in its own file.
ParticleTable read_csv(const Source& source);
ParticleTable read_vtu(const Source& source);
ParticleTable read_ply(const Source& source);
ParticleTable read_dump(const Source& source);
ParticleTable read_nairn(const Source& source);
ParticleTable read_nairn_legacy(const Source& source);

/// What the file holds. `format` is a word of `formats()`; empty: as the name's ending says. UsageError when it cannot
/// be read.
Snapshot read_snapshot(const std::filesystem::path& file, const Columns& columns, const std::string& format = "");

/// Several files as one state, as each process of a code writes one. They must have the same fields and say the same.
Snapshot read_snapshot(const std::vector<std::filesystem::path>& parts, const Columns& columns,
                       const std::string& format = "");

}  // namespace mpmvv::codes
