#include "cli/forecast.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "studies/plan/forecast.hpp"

namespace mpmvv::cli {

namespace {

nlohmann::json json_of(const plan::StudyForecast& s) {
  return {{"study", s.study}, {"cases", s.cases}, {"stored", s.stored}, {"shared", s.shared},   {"runs", s.runs},
          {"parts", s.parts}, {"timed", s.timed}, {"probes", s.probes}, {"seconds", s.seconds}, {"why", s.why}};
}

}  // namespace

void print_forecast(const std::vector<plan::StudyPlan>& plans, const plan::Work& work, const std::string& db, int jobs,
                    bool as_json) {
  store::require_place(db);
  std::optional<store::Store> store;
  if (std::filesystem::exists(db)) store.emplace(db, store::Store::Mode::read);
  const plan::Forecast all = plan::forecast(plans, work, store ? &*store : nullptr, jobs);
  if (as_json) {
    nlohmann::json json{{"jobs", jobs},
                        {"core_seconds", all.core_seconds},
                        {"timed_seconds", all.timed_seconds},
                        {"seconds", all.seconds},
                        {"studies", nlohmann::json::array()}};
    for (const plan::StudyForecast& study : all.studies) json["studies"].push_back(json_of(study));
    return print_json(json);
  }
  static constexpr const char* row = "{:<18} {:>7} {:>8} {:>8} {:>8} {:>7} {:>7} {:>8} {:>11}\n";
  print(row, "study", "cases", "stored", "shared", "to run", "parts", "timed", "probes", "on a core");
  for (const plan::StudyForecast& s : all.studies) {
    print(row, s.study, s.cases, s.stored, s.shared, s.runs, s.parts, s.timed, s.probes, duration_text(s.seconds));
    print_indented(s.why);
  }
  print("about {} on {} jobs, {} on one; of it {} alone on the machine, at the end\n", duration_text(all.seconds), jobs,
        duration_text(all.core_seconds), duration_text(all.timed_seconds));
}

}  // namespace mpmvv::cli
