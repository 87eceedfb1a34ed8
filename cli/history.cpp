#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/change_text.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "cli/results.hpp"
#include "cli/table.hpp"
#include "goldens/comparison.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using claims::Finding;
using claims::Trend;
using goldens::Change;
using store::Store;
using store::Version;

namespace {

nlohmann::json version_json(const Version& version, const std::string& code) {
  nlohmann::json json{{"digest", version.digest}, {"time", version.time}};
  if (code.empty())
    json["commits"] = version.commits;
  else
    json["code"] = code, json["version"] = version.commits.front();
  return json;
}

nlohmann::json change_json(const Change& change) {
  const auto side = [](const Finding& finding) -> nlohmann::json {
    return finding.word.empty() ? nlohmann::json(finding.number) : nlohmann::json(finding.word);
  };
  nlohmann::json json{
      {"study", change.before.study}, {"kind", to_string(change.before.kind)}, {"name", change.before.name}};
  if (!goldens::is_curve(change.before)) json["before"] = side(change.before), json["after"] = side(change.after);
  if (!std::isnan(change.before.at)) json["at"] = {{"before", change.before.at}, {"after", change.after.at}};
  if (!std::isnan(change.before.uncertainty))
    json["uncertainty"] = {{"before", change.before.uncertainty}, {"after", change.after.uncertainty}};
  if (!change.before.monotone || !change.after.monotone)
    json["monotone"] = {{"before", change.before.monotone}, {"after", change.after.monotone}};
  if (change.largest)
    json["largest"] = {{"x", change.largest->x}, {"before", change.largest->before}, {"after", change.largest->after}};
  return json;
}

struct CompareOptions {
  std::string db, code, a, b;
  bool json = false, all = false;
};

void print_comparison(const goldens::Comparison& comparison, const Version& a, const Version& b, bool all) {
  print_indented(fmt::format("from {}, {}", label(a), a.time), 0);
  print_indented(fmt::format("to   {}, {}", label(b), b.time), 0);
  if (&a == &b) print_indented("both are one version: what decides a result is the same in them", 0);
  Table table({{"study"}, {"change", Table::Kind::prose}}, 0);
  for (const Change& change : comparison.changes)
    if (all || change.bands != 0) table.add({change.before.study, change_text(change)});
  for (const Change& cost : comparison.costs) table.add({cost.before.study, change_text(cost)});
  table.print();
  for (const std::string& what : comparison.only_before) print("only in the first: {}\n", what);
  for (const std::string& what : comparison.only_after) print("only in the second: {}\n", what);
  print_indented(fmt::format("{} of {} results changed by more than round-off ({:g} relative, {:g} absolute); {} "
                             "shown as ratios",
                             comparison.changed(), comparison.changes.size(), goldens::relative_round_off,
                             goldens::absolute_round_off, count_text(comparison.costs.size(), "cost")),
                 0);
}

nlohmann::json comparison_json(const goldens::Comparison& comparison, const Version& a, const Version& b,
                               const CompareOptions& options) {
  nlohmann::json changes = nlohmann::json::array(), costs = nlohmann::json::array();
  for (const Change& change : comparison.changes)
    if (options.all || change.bands != 0) changes.push_back(change_json(change));
  for (const Change& cost : comparison.costs) costs.push_back(change_json(cost));
  return {{"from", version_json(a, options.code)},
          {"to", version_json(b, options.code)},
          {"round_off", {{"relative", goldens::relative_round_off}, {"absolute", goldens::absolute_round_off}}},
          {"compared", comparison.changes.size()},
          {"changed", comparison.changed()},
          {"changes", changes},
          {"costs", costs},
          {"only_from", comparison.only_before},
          {"only_to", comparison.only_after}};
}

std::string whose(const std::string& code) {
  return code.empty() ? "mpmvv" : code;
}

/// The second version. Where none is named it is that of the running program, or the newest of another code.
const Version& second_version(const CompareOptions& options, const std::vector<Version>& versions) {
  if (!options.b.empty()) return store::find_version(versions, options.b, whose(options.code));
  return options.code.empty() ? store::find_version(versions, store::current_provenance().digest) : versions.back();
}

int compare_versions(const CompareOptions& options) {
  const Store store(options.db, Store::Mode::read);
  const auto versions = versions_in(store, options.code);
  const Version& a = store::find_version(versions, options.a, whose(options.code));
  const Version& b = second_version(options, versions);
  const goldens::Comparison comparison =
      goldens::compare(findings_in(store, options.code, a), findings_in(store, options.code, b));
  if (options.json)
    print_json(comparison_json(comparison, a, b, options));
  else
    print_comparison(comparison, a, b, options.all);
  return 0;
}

struct TrendOptions {
  std::string db, code;
  bool json = false;
};

/// Whether one of its numbers from this version on has a remark.
bool is_marked(const Trend& trend, std::size_t first) {
  for (std::size_t v = first; v < trend.numbers.size(); ++v)
    if (!std::isnan(trend.numbers[v]) && !trend.remarks[v].empty()) return true;
  return false;
}

bool has_remarks(const Trend& trend) {
  return std::ranges::any_of(trend.remarks, [](const std::string& remark) { return !remark.empty(); });
}

nlohmann::json trends_json(const std::vector<Version>& versions, const std::vector<Trend>& trends,
                           const std::string& code) {
  nlohmann::json all_versions = nlohmann::json::array(), all_trends = nlohmann::json::array();
  for (const Version& version : versions) all_versions.push_back(version_json(version, code));
  for (const Trend& trend : trends) {
    all_trends.push_back(
        {{"study", trend.study}, {"kind", to_string(trend.kind)}, {"name", trend.name}, {"values", trend.numbers}});
    const std::string unit = records::unit_of(trend.quantity);
    if (!unit.empty()) all_trends.back()["unit"] = unit;
    if (!std::isnan(trend.at)) all_trends.back()["at"] = trend.at;
    if (has_remarks(trend)) all_trends.back()["remarks"] = trend.remarks;
  }
  return {{"versions", all_versions}, {"trends", all_trends}};
}

/// How many of the newest versions fit on a line of the terminal beside study and name.
std::size_t shown_versions(std::size_t all) {
  constexpr std::size_t beside = 45, column = 11;
  if (!output_columns()) return all;
  return std::min(all, std::max<std::size_t>(2, (std::max(text_width(), beside) - beside) / column));
}

/// The number; its remark where there is none.
std::string cell(const Trend& trend, std::size_t version) {
  const double number = trend.numbers[version];
  const std::string& remark = trend.remarks[version];
  if (std::isnan(number) && !remark.empty()) return remark;
  return number_text(number) + (remark.empty() ? "" : "*");
}

void print_trends(const std::vector<Version>& versions, const std::vector<Trend>& trends) {
  std::vector<Table::Column> columns{{"study"}};
  Table numbered({{"", Table::Kind::number}, {"", Table::Kind::prose}});
  const std::size_t first = versions.size() - shown_versions(versions.size());
  for (std::size_t v = first; v < versions.size(); ++v) {
    numbered.add({fmt::format("{}", v + 1), fmt::format("{}, {}", label(versions[v]), versions[v].time)});
    columns.push_back({fmt::format("version\n{}", v + 1), Table::Kind::number});
  }
  columns.push_back({"result", Table::Kind::prose});
  Table table(columns, 0);
  for (const Trend& trend : trends) {
    std::vector<std::string> cells{trend.study};
    for (std::size_t v = first; v < versions.size(); ++v) cells.push_back(cell(trend, v));
    cells.push_back(label_with_unit(trend));
    table.add(std::move(cells));
  }
  numbered.print();
  table.print();
  if (std::ranges::any_of(trends, [&](const Trend& trend) { return is_marked(trend, first); }))
    print_indented("* of runs that are not all ok: some are unstable or failed", 0);
  if (first > 0) print_indented(fmt::format("versions 1 to {} find no room in this width: --json has all", first), 0);
}

int trend(const TrendOptions& options) {
  const Store store(options.db, Store::Mode::read);
  const auto versions = versions_in(store, options.code);
  if (versions.empty())
    throw support::UsageError(fmt::format("{} holds no study of mpmvv (run `mpmvv study` first)", options.db));
  const auto trends = trends_in(store, options.code, versions);
  if (options.json)
    print_json(trends_json(versions, trends, options.code));
  else
    print_trends(versions, trends);
  return 0;
}

void add_code(CLI::App& command, std::string& code) {
  command.add_option("--code", code, "versions of this other code, by the series that it ran (default: of mpmvv)")
      ->type_name("CODE");
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Print what changed between two versions in a store, worst first");
  command->add_option("from", options->a, "first letters of a commit or digest; of a code, of its version or digest")
      ->required()
      ->type_name("VERSION");
  command
      ->add_option("to", options->b, "the same (default: the running program's digest; of a code, its newest version)")
      ->type_name("VERSION");
  add_code(*command, options->code);
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  command->add_flag("--all", options->all, "print what did not change, too");
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command, {"mpmvv compare 3f2a91 c0ffee --db results.db", "mpmvv compare 3f2a91 --db results.db --all",
                          "mpmvv compare 1.3 1.4 --code my-code --db results.db"});
  command->callback([options, &exit_code] { exit_code = compare_versions(*options); });
}

void add_trend(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TrendOptions>();
  CLI::App* command =
      app.add_subcommand("trend", "Print orders, finest errors, limits and values over all versions in a store");
  command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
  add_code(*command, options->code);
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command, {"mpmvv trend --db results.db", "mpmvv trend --code my-code --db results.db"});
  command->callback([options, &exit_code] { exit_code = trend(*options); });
}

}  // namespace mpmvv::cli
