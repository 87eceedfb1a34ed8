#include "studies/codes/snapshot.hpp"

#include <fmt/format.h>

namespace mpmvv::codes {

void Snapshot::leave_out(const std::string& key) {
  says.erase(key);
  for (SnapshotPart& part : parts) part.says.erase(key);
}

std::string name_of_particle(const Snapshot& s, std::size_t row) {
  if (!s.id.empty()) return fmt::format("particle {}", s.id[row]);
  for (const SnapshotPart& part : s.parts) {
    if (row < part.rows) return fmt::format("row {} of {}", row + 1, part.file);
    row -= part.rows;
  }
  return fmt::format("row {}", row + 1);
}

}  // namespace mpmvv::codes
