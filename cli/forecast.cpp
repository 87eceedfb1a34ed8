#include "cli/forecast.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/console.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"
#include "studies/plan/cautions.hpp"
#include "studies/plan/forecast.hpp"

namespace mpmvv::cli {

namespace {

nlohmann::json json_of(const plan::StudyForecast& s) {
  return {{"study", s.study},   {"cases", s.cases},     {"stored", s.stored}, {"shared", s.shared},
          {"runs", s.runs},     {"parts", s.parts},     {"timed", s.timed},   {"anew", s.anew},
          {"probes", s.probes}, {"seconds", s.seconds}, {"why", s.why}};
}

void print_studies(const std::vector<plan::StudyForecast>& studies) {
  using Kind = Table::Kind;
  Table table({{"study"},
               {"cases", Kind::number},
               {"stored", Kind::number},
               {"shared", Kind::number},
               {"to run", Kind::number},
               {"parts", Kind::number},
               {"timed", Kind::number},
               {"probes", Kind::number},
               {"on a\ncore", Kind::number},
               {"why", Kind::prose}},
              0);
  for (const plan::StudyForecast& s : studies) {
    std::vector<std::string> cells{s.study};
    for (const auto count : {s.cases, s.stored, s.shared, s.runs, s.parts, s.timed, s.probes})
      cells.push_back(fmt::format("{}", count));
    cells.insert(cells.end(), {duration_text(s.seconds), s.why});
    table.add(std::move(cells));
  }
  table.print();
}

std::vector<std::string> texts_of_cautions(const std::vector<plan::StudyPlan>& plans) {
  std::vector<std::string> texts;
  for (const plan::StudyPlan& study : plans)
    for (const plan::Caution& caution : plan::cautions(study)) texts.push_back(caution_text(study.name, caution));
  return texts;
}

}  // namespace

void print_forecast(const std::vector<plan::StudyPlan>& plans, const plan::Work& work, const std::string& db,
                    const store::Store* costs, int jobs, bool as_json) {
  store::require_place(db);
  std::optional<store::Store> held;
  if (std::filesystem::exists(db)) held.emplace(db, store::Store::Mode::read);
  const store::Store* store = held ? &*held : nullptr;
  const plan::Forecast all = plan::forecast(plans, work, store, plan::CostModel(costs ? costs : store), jobs);
  if (as_json) {
    nlohmann::json json{
        {"jobs", jobs},           {"core_seconds", all.core_seconds},   {"timed_seconds", all.timed_seconds},
        {"seconds", all.seconds}, {"studies", nlohmann::json::array()}, {"cautions", texts_of_cautions(plans)}};
    for (const plan::StudyForecast& study : all.studies) json["studies"].push_back(json_of(study));
    return print_json(json);
  }
  print_studies(all.studies);
  print_indented(fmt::format("about {} on {}, {} on one; of it {} alone on the machine, at the end",
                             duration_text(all.seconds), count_text(static_cast<std::size_t>(jobs), "job"),
                             duration_text(all.core_seconds), duration_text(all.timed_seconds)),
                 0);
  for (const std::string& caution : texts_of_cautions(plans)) note("{}\n", caution);
}

}  // namespace mpmvv::cli
