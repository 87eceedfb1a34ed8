#include "studies/records/result.hpp"

#include <algorithm>

namespace mpmvv::records {

bool speaks_of(const ClaimPart& part, const std::vector<Series>& series) {
  const std::string text = part.found.empty() ? part.statement + part.evidence : part.evidence;
  return std::ranges::any_of(series,
                             [&](const Series& s) { return text.find('\'' + s.name + '\'') != std::string::npos; });
}

}  // namespace mpmvv::records
