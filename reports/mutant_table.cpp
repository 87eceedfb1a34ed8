#include "reports/mutant_table.hpp"

#include <fmt/format.h>

#include <functional>

namespace mpmvv::reports {

namespace {

std::string of_all(int part, int all) {
  return all == 0 ? "–" : fmt::format("{} of {} ({:.0f} %)", part, all, 100.0 * part / all);
}

Table score_table(const MutationResults& mutation) {
  const PlantedScore& planted = mutation.planted;
  const RandomScore& random = mutation.random;
  const int tried = planted.should_show - planted.untried;
  Table table{"Score: how many mistakes the unit tests and each gate catch",
              {"mistakes", "unit tests", "quick gate", "nightly gate, of what these miss", "any of them"},
              {},
              "Mistakes in reports/ and studies/codes/ change no golden: the unit tests alone can see them."};
  if (random.tried > 0) table.columns.emplace_back("explained");
  if (planted.should_show + planted.equivalent + random.tried == 0) return table;
  Table::Group group;
  const auto add = [&](std::vector<std::string> row) {
    row.resize(table.columns.size());
    group.rows.push_back(std::move(row));
  };
  add({"planted, should show", of_all(planted.unit_tests, tried), of_all(planted.quick, tried),
       planted.nightly == 0 ? "–" : fmt::format("{}", planted.nightly), of_all(planted.caught, tried)});
  if (planted.untried > 0) add({fmt::format("planted, not tried yet: {}", planted.untried)});
  if (planted.equivalent > 0) add({fmt::format("planted, efficiency or robustness only: {}", planted.equivalent)});
  if (random.tried > 0)
    add({"random", "", "", "", of_all(random.caught, random.tried),
         of_all(random.explained, random.tried - random.caught)});
  table.groups.push_back(std::move(group));
  return table;
}

std::string stage_text(const MutantResult& mutant, const std::optional<StageResult>& stage) {
  if (!mutant.builds) return "does not compile";
  if (!stage) return mutant.is_untried() ? "not tried yet" : "–";
  if (!stage->caught) return "passes";
  const std::string more = stage->by.size() > 1 ? fmt::format(" and {} more", stage->by.size() - 1) : "";
  return stage->by.empty() ? "caught" : stage->by.front() + more;
}

/// The mistake's name. It says where the result is of an earlier gate: such a result stands until the mistake is tried
/// anew.
std::string name_text(const MutantResult& mutant) {
  return mutant.by_earlier_gate ? mutant.name + " (earlier gate)" : mutant.name;
}

std::string place(const MutantResult& mutant) {
  return mutant.line == 0 ? mutant.file : fmt::format("{}:{}", mutant.file, mutant.line);
}

/// Puts the mutants without and those with a reason in two titled groups.
Table grouped(Table table, const std::vector<MutantResult>& mutants,
              const std::function<std::vector<std::string>(const MutantResult&)>& row, const char* without_reason,
              const char* with_reason) {
  Table::Group open{without_reason, {}}, explained{with_reason, {}};
  for (const MutantResult& mutant : mutants) (mutant.reason.empty() ? open : explained).rows.push_back(row(mutant));
  for (Table::Group* group : {&open, &explained})
    if (!group->rows.empty()) table.groups.push_back(std::move(*group));
  return table;
}

Table planted_table(const std::vector<MutantResult>& mistakes) {
  return grouped(
      {"Planted mistakes, and what catches them: the first test, the goldens",
       {"mistake", "what", "where", "unit tests", "quick gate", "nightly gate", "reason"},
       {}},
      mistakes,
      [](const MutantResult& m) -> std::vector<std::string> {
        return {name_text(m),
                m.what,
                place(m),
                stage_text(m, m.unit_tests),
                stage_text(m, m.quick),
                stage_text(m, m.nightly),
                m.reason};
      },
      "that an order, an error, a limit or a report can show", "that change efficiency or robustness only");
}

/// Drops the column of names where it is empty: a published summary does not name its mutations.
Table without_empty_first_column(Table table) {
  for (const Table::Group& group : table.groups)
    for (const auto& row : group.rows)
      if (!row.front().empty()) return table;
  table.columns.erase(table.columns.begin());
  for (Table::Group& group : table.groups)
    for (auto& row : group.rows) row.erase(row.begin());
  return table;
}

Table survivor_table(const std::vector<MutantResult>& survivors) {
  return without_empty_first_column(grouped(
      {"Random mutations that nothing catches", {"mutation", "where", "line", "with the mutation", "reason"}, {}},
      survivors,
      [](const MutantResult& m) -> std::vector<std::string> {
        return {name_text(m), place(m), m.before, m.after, m.reason};
      },
      "not explained", "explained"));
}

Table alarm_table(const std::vector<AlarmCount>& builds) {
  Table table{"False alarms: the quick gate without a mistake, other orders and places of the particles",
              {"build", "runs", "goldens judged", "false alarms"},
              {}};
  Table::Group group;
  for (const AlarmCount& of : builds)
    group.rows.push_back(
        {of.build, fmt::format("{}", of.runs), fmt::format("{}", of.judged), fmt::format("{}", of.alarms)});
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

}  // namespace

std::vector<Table> mutant_tables(const MutationResults& mutation, const std::vector<AlarmCount>& alarms) {
  std::vector<Table> tables;
  for (Table table : {score_table(mutation), planted_table(mutation.mistakes), survivor_table(mutation.survivors),
                      alarm_table(alarms)})
    if (!table.empty()) tables.push_back(std::move(table));
  return tables;
}

}  // namespace mpmvv::reports
