#include "reports/process_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mpmvv::reports {

std::string process_time_note(const std::vector<const records::Series*>& series) {
  std::vector<std::string> names;
  for (const records::Series* one : series)
    if (records::is_of_another_code(*one)) names.push_back(one->name);
  if (names.empty()) return "";
  return fmt::format("Of other codes the time is that of the whole process, start included, not of the steps: {}.",
                     fmt::join(names, "; "));
}

}  // namespace mpmvv::reports
