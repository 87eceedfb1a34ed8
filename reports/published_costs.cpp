#include "reports/published_costs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page_template.hpp"
#include "reports/text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

namespace {

constexpr std::string_view scheme = "https://";

std::string address(const support::TomlTable& table) {
  std::string text = table.text("source");
  if (!text.starts_with(scheme))
    throw support::UsageError(fmt::format("'{}' in {} is no address ({}...)", text, table.where("source"), scheme));
  return text;
}

double positive(const support::TomlTable& table, const char* key) {
  const double value = table.number(key);
  if (!(value > 0)) throw support::UsageError(fmt::format("{} in {} is no size (a number > 0)", key, table.where(key)));
  return value;
}

PublishedCost code_from(const support::TomlTable& table) {
  table.allow_only({"on", "name", "what", "precision", "hardware", "published", "seconds", "steps", "particles",
                    "beside", "source", "date"});
  return {.on = table.text("on"),
          .name = table.text("name"),
          .what = table.text("what"),
          .precision = table.text("precision"),
          .hardware = table.text("hardware"),
          .published = table.text("published"),
          .seconds = positive(table, "seconds"),
          .steps = positive(table, "steps"),
          .particles = positive(table, "particles"),
          .beside = table.text("beside"),
          .source = address(table),
          .date = table.text("date")};
}

/// The case that a published cost is set beside; null when it was not measured.
const BenchmarkRow* case_beside(const Benchmark& benchmark, const std::string& beside) {
  const auto row = std::ranges::find_if(
      benchmark.rows, [&](const BenchmarkRow& r) { return (r.name + "/").starts_with("case/" + beside + "/"); });
  return row == benchmark.rows.end() ? nullptr : &*row;
}

}  // namespace

std::vector<PublishedCost> read_published_costs(const std::string& text, const std::string& name) {
  std::vector<PublishedCost> codes;
  for (const auto& table : support::TomlTable::parse(text, name).tables("code")) codes.push_back(code_from(table));
  return codes;
}

const std::vector<PublishedCost>& published_costs() {
  static const auto codes = read_published_costs(std::string(published_costs_text), "reports/published_costs.toml");
  return codes;
}

Table others_table(const Benchmark& benchmark, const std::vector<PublishedCost>& codes) {
  Table table{
      "Time of others: ns per particle and step as published or measured, beside this program's on one core of this "
      "machine in a case of the same dimension, particles per cell and kind of basis",
      {"code", "what", "precision", "hardware", "as published", "ns", "ours, ns", "times ours", "source", "date"},
      {}};
  for (const PublishedCost& code : codes) {
    const BenchmarkRow* own = case_beside(benchmark, code.beside);
    if (!own) continue;
    auto group = std::ranges::find(table.groups, code.on, &Table::Group::title);
    if (group == table.groups.end()) group = table.groups.insert(group, Table::Group{code.on, {}});
    const double ours = own->median("per_particle_step");
    const bool is_comparable = code.hardware != "not said";
    group->rows.push_back({code.name, code.what, code.precision, code.hardware, code.published,
                           three_digits(1e9 * code.per_particle_step()), three_digits(1e9 * ours),
                           is_comparable ? three_digits(code.per_particle_step() / ours) : "–", code.source,
                           code.date});
  }
  return table;
}

}  // namespace mpmvv::reports
