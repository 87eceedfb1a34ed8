#include "reports/mutant_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

namespace mpmvv::reports {

namespace {

std::string of_all(int part, int all) {
  return all == 0 ? "–" : fmt::format("{} of {} ({:.0f} %)", part, all, 100.0 * part / all);
}

bool is_untried(const Mutant& mutant) {
  return mutant.kind == Mutant::Kind::planted && mutant.builds && mutant.trials.empty();
}

Table score_table(const std::vector<Mutant>& mutants) {
  std::vector<Mutant> tried = mutants;
  const std::size_t untried = std::erase_if(tried, is_untried);
  const MutantScore score = score_of(tried);
  Table table{"Score: how many mistakes each part of the gate catches",
              {"mistakes", "unit tests", "quick gate", "nightly gate, of what these miss", "any of them", "explained"},
              {}};
  Table::Group group;
  group.rows.push_back(
      {"planted, should show", of_all(score.by_unit_tests, score.planted), of_all(score.by_quick, score.planted),
       score.by_nightly == 0 ? "–" : fmt::format("{}", score.by_nightly), of_all(score.by_any, score.planted), ""});
  if (untried > 0) group.rows.push_back({fmt::format("planted, not tried yet: {}", untried), "", "", "", "", ""});
  if (score.silent > 0)
    group.rows.push_back({fmt::format("planted, efficiency or robustness only: {}", score.silent), "", "", "", "", ""});
  if (score.random > 0)
    group.rows.push_back({"random", "", "", "", of_all(score.random_caught, score.random),
                          of_all(score.random_explained, score.random - score.random_caught)});
  table.groups.push_back(std::move(group));
  return table;
}

std::string trial_text(const Mutant& mutant, GateStage stage) {
  const Trial* trial = mutant.trial(stage);
  if (!mutant.builds) return "does not compile";
  if (!trial) return is_untried(mutant) ? "not tried yet" : "–";
  if (!trial->caught) return "passes";
  const std::string more = trial->by.size() > 1 ? fmt::format(" and {} more", trial->by.size() - 1) : "";
  return trial->by.empty() ? "caught" : trial->by.front() + more;
}

/// The version of the gate that the unchanged tree passed last.
std::string newest_gate(const std::vector<Mutant>& mutants) {
  std::string gate;
  for (const Mutant& mutant : mutants)
    if (mutant.kind == Mutant::Kind::baseline) gate = mutant.gate;
  return gate;
}

/// Names of mistakes whose results are of an older gate say so: these stand until they are tried anew.
std::string name_text(const Mutant& mutant, const std::string& gate) {
  return mutant.trials.empty() || mutant.gate == gate ? mutant.name : mutant.name + " (earlier gate)";
}

std::string place(const Mutant& mutant) {
  return is_untried(mutant) ? mutant.file : fmt::format("{}:{}", mutant.file, mutant.line);
}

/// A table of those that belong to one of two titled groups.
Table grouped(Table table, const std::vector<Mutant>& mutants, const std::function<bool(const Mutant&)>& belongs,
              const std::function<std::vector<std::string>(const Mutant&)>& row, const char* without_reason,
              const char* with_reason) {
  Table::Group open{without_reason, {}}, explained{with_reason, {}};
  for (const Mutant& mutant : mutants)
    if (belongs(mutant)) (mutant.reason.empty() ? open : explained).rows.push_back(row(mutant));
  for (Table::Group* group : {&open, &explained})
    if (!group->rows.empty()) table.groups.push_back(std::move(*group));
  return table;
}

Table planted_table(const std::vector<Mutant>& mutants) {
  const std::string gate = newest_gate(mutants);
  return grouped(
      {"Planted mistakes, and what catches them: the first test, the goldens",
       {"mistake", "what", "where", "unit tests", "quick gate", "nightly gate", "reason"},
       {}},
      mutants, [](const Mutant& m) { return m.kind == Mutant::Kind::planted; },
      [&](const Mutant& m) -> std::vector<std::string> {
        return {name_text(m, gate),
                m.what,
                place(m),
                trial_text(m, GateStage::unit_tests),
                trial_text(m, GateStage::quick),
                trial_text(m, GateStage::nightly),
                m.reason};
      },
      "that an order, an error, a limit or a report can show", "that change efficiency or robustness only");
}

Table survivor_table(const std::vector<Mutant>& mutants) {
  const std::string gate = newest_gate(mutants);
  return grouped(
      {"Random mutations that nothing catches", {"mutation", "where", "line", "with the mutation", "reason"}, {}},
      mutants, [](const Mutant& m) { return m.kind == Mutant::Kind::random && m.builds && !m.caught(); },
      [&](const Mutant& m) -> std::vector<std::string> {
        return {name_text(m, gate), place(m), m.before, m.after, m.reason};
      },
      "not explained", "explained");
}

Table alarm_table(const std::vector<AlarmRun>& runs) {
  Table table{"False alarms: the quick gate without a mistake, other orders and places of the particles",
              {"build", "runs", "goldens judged", "false alarms"},
              {}};
  std::map<std::string, std::vector<AlarmRun>> by_build;
  for (const AlarmRun& run : runs) by_build[run.build].push_back(run);
  Table::Group group;
  for (const auto& [build, own] : by_build) {
    int judged = 0;
    for (const AlarmRun& run : own) judged += run.pass + run.fail + run.inconclusive;
    group.rows.push_back({build, fmt::format("{}", own.size()), fmt::format("{}", judged),
                          fmt::format("{}", std::ranges::count_if(own, &AlarmRun::is_alarm))});
  }
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

}  // namespace

std::vector<Table> mutant_tables(const std::vector<Mutant>& mutants, const std::vector<AlarmRun>& alarms) {
  std::vector<Table> tables;
  if (mutants.empty()) return tables;
  for (Table table : {score_table(mutants), planted_table(mutants), survivor_table(mutants), alarm_table(alarms)})
    if (!table.empty()) tables.push_back(std::move(table));
  return tables;
}

}  // namespace mpmvv::reports
