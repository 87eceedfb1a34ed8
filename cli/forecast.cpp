#include "cli/forecast.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/console.hpp"
#include "studies/plan/forecast.hpp"

namespace mpmvv::cli {

namespace {

std::string minutes(double seconds) {
  return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

nlohmann::json json_of(const plan::StudyForecast& s) {
  return {{"study", s.study}, {"cases", s.cases}, {"stored", s.stored}, {"shared", s.shared},   {"runs", s.runs},
          {"parts", s.parts}, {"timed", s.timed}, {"probes", s.probes}, {"seconds", s.seconds}, {"why", s.why}};
}

}  // namespace

void print_forecast(const std::vector<plan::StudyPlan>& plans, const std::string& db, int jobs, bool as_json) {
  std::optional<store::Store> store;
  if (std::filesystem::exists(db)) store.emplace(db, store::Store::Mode::read);
  const plan::Forecast all = plan::forecast(plans, store ? &*store : nullptr, jobs);
  if (as_json) {
    nlohmann::json json{{"jobs", jobs},
                        {"core_seconds", all.core_seconds},
                        {"timed_seconds", all.timed_seconds},
                        {"seconds", all.seconds},
                        {"studies", nlohmann::json::array()}};
    for (const plan::StudyForecast& study : all.studies) json["studies"].push_back(json_of(study));
    return print_json(json);
  }
  print("{:<18} {:>6} {:>7} {:>7} {:>6} {:>6} {:>6} {:>7} {:>10}  {}\n", "study", "cases", "stored", "shared", "to run",
        "parts", "timed", "probes", "on a core", "why");
  for (const plan::StudyForecast& s : all.studies)
    print("{:<18} {:>6} {:>7} {:>7} {:>6} {:>6} {:>6} {:>7} {:>10}  {}\n", s.study, s.cases, s.stored, s.shared, s.runs,
          s.parts, s.timed, s.probes, minutes(s.seconds), s.why);
  print("about {} on {} jobs, {} on one; of it {} alone on the machine, at the end\n", minutes(all.seconds), jobs,
        minutes(all.core_seconds), minutes(all.timed_seconds));
}

}  // namespace mpmvv::cli
