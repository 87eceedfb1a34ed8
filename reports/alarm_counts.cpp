#include "reports/alarm_counts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

namespace {

int count_of(const support::TomlTable& table, const char* key) {
  const double number = table.number(key);
  if (number < 0 || number > 1e9 || std::trunc(number) != number)
    throw support::UsageError(fmt::format("{} = {} in {} (a count)", key, number, table.where(key)));
  return static_cast<int>(number);
}

}  // namespace

AlarmCounts read_alarms(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const support::TomlTable document = support::TomlTable::read(file);
  document.allow_only({"digest", "gate", "build"});
  AlarmCounts counts{document.text("digest"), {}};
  for (const support::TomlTable& table : document.tables("build")) {
    table.allow_only({"name", "runs", "judged", "alarms"});
    counts.builds.push_back({.build = table.text("name"),
                             .runs = count_of(table, "runs"),
                             .judged = count_of(table, "judged"),
                             .alarms = count_of(table, "alarms")});
  }
  return counts;
}

}  // namespace mpmvv::reports
