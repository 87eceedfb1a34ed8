#include "goldens/golden.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "studies/fits/window.hpp"
#include "studies/support/error.hpp"
#include "studies/support/shell.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::goldens {

using support::TomlTable;

namespace {

constexpr double round_off = 1e-9;  ///< so that 2 - 1.85 is not wider than 0.15

[[noreturn]] void reject(const std::string& wrong, const std::string& where, const std::string& right) {
  throw support::UsageError(fmt::format("{} in {} ({})", wrong, where, right));
}

double number(const TomlTable& table, const std::string& key) {
  const double value = table.number(key);
  if (std::abs(value) > largest_number)
    reject(fmt::format("'{}' is {}", key, value), table.where(key), "a number that a result may have");
  return value;
}

double positive(const TomlTable& table, const std::string& key) {
  const double value = number(table, key);
  if (!(value > 0)) reject(fmt::format("'{}' is {}", key, value), table.where(key), "a number above 0");
  return value;
}

/// A number of points that an order can be fitted to.
int points(const TomlTable& table) {
  constexpr int least = 3, most = 1'000'000;
  const double value = table.number("points");
  if (!(value >= least && value <= most && value == std::floor(value)))
    reject(fmt::format("'points' is {}", value), table.where("points"),
           fmt::format("a whole number from {} to {}", least, most));
  return static_cast<int>(value);
}

std::string word(const TomlTable& table, const std::string& key) {
  const std::string text = table.text(key);
  if (text.find_first_not_of(" \t\n") == std::string::npos) {
    reject(fmt::format("'{}' is blank", key), table.where(key), "a text");
  }
  return text;
}

std::string norm(const TomlTable& table) {
  const std::vector<std::string> known = golden_norms();
  const std::string text = table.text("norm");
  if (std::ranges::find(known, text) == known.end()) {
    reject(fmt::format("unknown norm '{}'", text), table.where("norm"),
           fmt::format("known: {}", fmt::join(known, ", ")));
  }
  return text;
}

/// A band wider than the usual one (golden.hpp) needs a reason, under `why`.
void justify(const TomlTable& table, double width, double allowed, const std::string& rule) {
  if (table.has("why")) word(table, "why");
  if (width > allowed + round_off && !table.has("why")) {
    reject(fmt::format("a band of {:.6g} without 'why'", width), table.where(),
           fmt::format("{}, unless why = \"...\" justifies a wider one", rule));
  }
}

double relative_band(const TomlTable& table, double allowed, const std::string& of_what) {
  const double band = positive(table, "band");
  if (band >= 1)
    reject(fmt::format("a band of {:.6g}", band), table.where("band"), "below 1, which is the number itself");
  justify(table, band, allowed, fmt::format("{} within {:g} %", of_what, 100 * allowed));
  return band;
}

/// Two swept values, the smaller first.
std::vector<double> window(const TomlTable& table) {
  const auto ends = table.numbers("window");
  if (ends.size() != 2 || !(0 < ends[0] && ends[0] < ends[1] && ends[1] <= largest_number))
    reject("a window that is none", table.where("window"), "two swept values above 0, the smaller first");
  return ends;
}

/// A swept value, inside the window where there is one, and the error there.
std::vector<double> finest(const TomlTable& table, const std::vector<double>& window) {
  const auto level = table.numbers("finest");
  const auto sound = [](double x) { return x > 0 && x <= largest_number; };
  if (level.size() != 2 || !std::ranges::all_of(level, sound))
    reject("a finest level that is none", table.where("finest"), "a swept value and the error there, both above 0");
  if (!window.empty() && !fits::Window{window[0], window[1]}.holds(level[0]))
    reject(fmt::format("a finest level {} outside the window", level[0]), table.where("finest"),
           fmt::format("a swept value from {} to {}", window[0], window[1]));
  return level;
}

/// Reads the half-width of an interval. One wider than any band would let every order pass.
double interval(const TomlTable& table, double band) {
  const double width = positive(table, "interval"), widest = std::max(widest_interval, band);
  if (width > widest)
    reject(fmt::format("'interval' is {}", width), table.where("interval"),
           fmt::format("at most {:g}: an order that is known no better decides nothing", widest));
  return width;
}

OrderGolden read_order(const TomlTable& table) {
  table.allow_only(
      {"series", "norm", "expected", "lower", "upper", "window", "points", "asymptotic", "interval", "finest", "why"});
  OrderGolden golden{word(table, "series"), norm(table), number(table, "expected"), number(table, "lower"),
                     number(table, "upper")};
  if (!(golden.lower < golden.upper && golden.lower <= golden.expected && golden.expected <= golden.upper)) {
    reject(fmt::format("expected {} with lower {} and upper {}", golden.expected, golden.lower, golden.upper),
           table.where(), "lower <= expected <= upper, lower < upper");
  }
  justify(table, std::max(golden.upper - golden.expected, golden.expected - golden.lower), order_band,
          fmt::format("orders within {:g}", order_band));
  if (table.has("window")) golden.window = window(table);
  if (table.has("points")) golden.points = points(table);
  golden.asymptotic = table.flag("asymptotic", false);
  if (table.has("interval")) golden.interval = interval(table, golden.upper - golden.lower);
  if (table.has("finest")) golden.finest = finest(table, golden.window);
  return golden;
}

ErrorGolden read_error(const TomlTable& table) {
  table.allow_only({"series", "norm", "at", "expected", "band", "why"});
  return {word(table, "series"), norm(table), positive(table, "at"), positive(table, "expected"),
          relative_band(table, error_band, "errors")};
}

LimitGolden read_limit(const TomlTable& table) {
  table.allow_only({"series", "expected", "band", "why"});
  return {word(table, "series"), positive(table, "expected"), relative_band(table, limit_band, "limits")};
}

ValueGolden read_value(const TomlTable& table) {
  table.allow_only({"name", "at_most", "at_least", "expected", "band", "why"});
  ValueGolden golden{word(table, "name")};
  if (table.has("at_most") + table.has("at_least") + table.has("expected") != 1) {
    reject(fmt::format("value '{}' without one clear bound", golden.name), table.where(),
           "at_most, or at_least, or expected with band");
  }
  if (table.has("expected")) {
    const double expected = number(table, "expected");
    const double reach = std::abs(expected) * relative_band(table, error_band, "check values");
    if (reach == 0) reject("'expected' is 0 with a relative band", table.where("expected"), "at_most or at_least");
    golden.lower = expected - reach;
    golden.upper = expected + reach;
    return golden;
  }
  if (table.has("band")) reject("'band' without 'expected'", table.where("band"), "expected with band");
  if (table.has("at_most")) golden.upper = number(table, "at_most");
  if (table.has("at_least")) golden.lower = number(table, "at_least");
  return golden;
}

StatusGolden read_status(const TomlTable& table) {
  table.allow_only({"series", "at", "expected", "why"});
  const std::string expected = table.text("expected");
  if (expected != "ok" && expected != "unstable") {
    reject(fmt::format("unknown status '{}'", expected), table.where("expected"), "known: ok, unstable");
  }
  return {word(table, "series"), positive(table, "at"),
          expected == "ok" ? records::Status::ok : records::Status::unstable};
}

std::vector<Golden> goldens_of(const TomlTable& document) {
  document.allow_only({"study", "reviewed", "order", "error", "limit", "value", "status"});
  const std::string study = word(document, "study");
  const bool reviewed = document.has("reviewed") && !word(document, "reviewed").empty();

  std::vector<Golden> goldens;
  const auto add = [&](const char* kind, auto read) {
    for (const TomlTable& table : document.tables(kind))
      goldens.push_back({study, table.where(), read(table), reviewed});
  };
  add("order", read_order);
  add("error", read_error);
  add("limit", read_limit);
  add("value", read_value);
  add("status", read_status);
  if (goldens.empty()) {
    reject("no expectation", document.where(), "at least one [[order]], [[error]], [[limit]], [[value]] or [[status]]");
  }
  return goldens;
}

void refuse_duplicates(const std::vector<Golden>& goldens) {
  std::map<std::pair<std::string, std::string>, std::string> first;
  for (const Golden& golden : goldens) {
    const auto [entry, is_new] = first.try_emplace({golden.study, subject(golden)}, golden.where);
    if (!is_new) {
      reject(fmt::format("a second golden for the {} of study '{}'", subject(golden), golden.study), golden.where,
             fmt::format("one each; the first is in {}", entry->second));
    }
  }
}

std::set<std::filesystem::path> golden_files(const std::filesystem::path& directory) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  return files;
}

/// How a directory comes to its first golden.
std::string first_golden_of(const std::filesystem::path& directory) {
  return fmt::format("`mpmvv propose --db DB --study NAME --out {}` writes a first one, to be reviewed",
                     support::shell_word((directory / "NAME.toml").string()));
}

}  // namespace

std::vector<std::string> golden_norms() {
  std::vector<std::string> known = records::norm_words();
  known.emplace_back("y");
  return known;
}

std::vector<Golden> parse_goldens(const std::string& text, const std::string& file) {
  std::vector<Golden> goldens = goldens_of(TomlTable::parse(text, file));
  refuse_duplicates(goldens);
  return goldens;
}

bool has_goldens(const std::filesystem::path& directory) {
  return std::filesystem::is_directory(directory) && !golden_files(directory).empty();
}

void require_directory(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory))
    throw support::UsageError(fmt::format("no directory '{}' (one with goldens, *.toml; {})", directory.string(),
                                          first_golden_of(directory)));
}

std::vector<Golden> read_goldens(const std::filesystem::path& directory) {
  require_directory(directory);
  const auto files = golden_files(directory);
  if (files.empty())
    throw support::UsageError(
        fmt::format("no golden in '{}' (at least one *.toml; {})", directory.string(), first_golden_of(directory)));

  std::vector<Golden> goldens;
  for (const std::filesystem::path& file : files) {
    std::ranges::move(goldens_of(TomlTable::read(file)), std::back_inserter(goldens));
  }
  refuse_duplicates(goldens);
  return goldens;
}

}  // namespace mpmvv::goldens
