#include "cli/max_age.hpp"

#include <fmt/format.h>

#include <chrono>

#include "cli/checks.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::cli {

void add_max_age(CLI::App& command, std::optional<int>& hours) {
  command
      .add_option("--max-age", hours,
                  "a study that was last run more than so many hours ago is inconclusive (default: any will do)")
      ->check(from_to(1, 100'000))
      ->type_name("HOURS");
}

std::map<std::string, std::string> outdated(const std::vector<records::StudyResult>& studies, const store::Store& store,
                                            std::optional<int> hours) {
  std::map<std::string, std::string> reasons;
  if (!hours) return reasons;
  const auto now = std::chrono::system_clock::now();
  const std::string earliest = store::time_text(now - std::chrono::hours(*hours));
  const std::string latest = store::time_text(now + std::chrono::hours(1));  // clocks of several machines may differ
  for (const records::StudyResult& study : studies) {
    const auto kept = store.study_provenance(study.name, store::current_provenance().digest);
    if (kept && kept->time < earliest)
      reasons[study.name] = fmt::format("last run {}, more than {} h ago", kept->time, *hours);
    else if (kept && kept->time > latest)
      reasons[study.name] = fmt::format("last run {}, in the future: a clock was wrong", kept->time);
  }
  return reasons;
}

}  // namespace mpmvv::cli
