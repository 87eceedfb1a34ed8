#include "reports/alarm_log.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

using support::TomlTable;
using support::UsageError;

namespace {

int count_of(const support::TomlTable& table, const char* key) {
  const double number = table.number(key);
  if (number < 0 || number > 1e9 || std::trunc(number) != number)
    throw support::UsageError(fmt::format("{} = {} in {} (a count)", key, number, table.where(key)));
  return static_cast<int>(number);
}

}  // namespace

AlarmLog read_alarms(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const support::TomlTable document = support::TomlTable::read(file);
  document.allow_only({"digest", "gate", "run"});
  AlarmLog log{document.text("digest"), {}};
  for (const support::TomlTable& table : document.tables("run")) {
    table.allow_only({"number", "build", "shuffle", "grid_offset", "pass", "fail", "inconclusive", "told"});
    log.runs.push_back({.build = table.text("build"),
                        .pass = count_of(table, "pass"),
                        .fail = count_of(table, "fail"),
                        .inconclusive = count_of(table, "inconclusive")});
  }
  return log;
}

}  // namespace mpmvv::reports
