#include "studies/plan/file_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "studies/claims/criterion.hpp"
#include "studies/plan/file_tables.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::plan {

using cases::SettingKey;
using claims::Criterion;

namespace {

const char* const introduction = R"(# The study file, key by key

A study file is TOML. This page lists every key that it may have. `mpmvv list study-file` prints the page from the tables by which the
program reads the file, and a test compares the two. If a file has anything else, one line says what is wrong, where, and what would be
right. [first-study.md](first-study.md) begins with a file and what it does; [own-study.md](own-study.md) says how to ask for limits, costs
and checks.

)";

std::string row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

/// "`series`, `norm`"; empty where there are no words.
std::string in_code(const std::vector<std::string>& words) {
  return words.empty() ? "" : fmt::format("`{}`", fmt::join(words, "`, `"));
}

std::string or_required(const std::string& absent) {
  return absent.empty() ? "**required**" : absent;
}

/// A paragraph in lines of the documents' width; what stands in code is not broken.
std::string paragraph(const std::string& text) {
  constexpr std::size_t width = 150;
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word, rest; words >> word;) {
    while (std::ranges::count(word, '`') % 2 == 1 && words >> rest) word += ' ' + rest;
    if (!line.empty() && line.size() + 1 + word.size() > width) lines += line + '\n', line.clear();
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + line + "\n\n";
}

std::string section(const FileTable& table) {
  std::string text = fmt::format("## {}\n\n", table.name.empty() ? table.heading : "`" + table.heading + "`") +
                     paragraph(table.meaning);
  if (table.keys.empty()) return text;
  text += "| key | takes | without it | meaning |\n|---|---|---|---|\n";
  for (const FileKey& key : table.keys)
    text += row({"`" + key.key + "`", key.takes, or_required(key.absent), key.meaning});
  return text + "\n";
}

struct Measure {
  const char* number;
  std::vector<std::string> needs;
};

Measure measure_of(Criterion::Kind kind) {
  switch (kind) {
    case Criterion::Kind::order:
      return {"order of `norm`, fitted over the window", {"series", "norm", "window"}};
    case Criterion::Kind::order_difference:
      return {"order in `norm` less that in `over_norm`", {"series", "norm", "over_norm", "window"}};
    case Criterion::Kind::error:
      return {"`norm` at every swept value in the window", {"series", "norm", "window"}};
    case Criterion::Kind::error_ratio:
      return {"`norm` of `series` over that of `over`, at every swept value in the window; two unstable runs are equal",
              {"series", "over", "norm", "window"}};
    case Criterion::Kind::spread:
      return {"largest over smallest `norm` at the swept values in the window", {"series", "norm", "window"}};
    case Criterion::Kind::status:
      return {"share of the points in the window whose run came to its end", {"series", "window"}};
    case Criterion::Kind::limit:
      return {"stability limit", {"series"}};
    case Criterion::Kind::limit_ratio:
      return {"stability limit of `series` over that of `over`", {"series", "over"}};
    case Criterion::Kind::value:
      return {"value of a check", {"name"}};
    case Criterion::Kind::cost_ratio:
      return {
          "cost at which `series` reaches each power of ten in the window (of errors in `norm`), over that of `over`",
          {"series", "over", "norm", "window"}};
    case Criterion::Kind::slope_ratio:
      return {"slope of `norm` against the swept value, over that of `over`", {"series", "over", "norm", "window"}};
    case Criterion::Kind::slope_share:
      return {"that slope over the first value of `over` in the window", {"series", "over", "norm", "window"}};
    case Criterion::Kind::shown:
      return {"none: the figure is the evidence", {}};
    case Criterion::Kind::awaited:
      return {"none: no study can judge this part of the claim; `reason` says what would decide it", {}};
  }
  return {};
}

std::string measures() {
  std::string text = "## Measures\n\n" +
                     paragraph(
                         "The number that a criterion asks for, and the keys that it needs beside `at_least` and "
                         "`at_most`. It takes no others; where there is no number, there are no bounds either.") +
                     "| measure | number | needs |\n|---|---|---|\n";
  for (std::size_t k = 0; k < words_of(Criterion::Kind{}).size(); ++k) {
    const auto kind = static_cast<Criterion::Kind>(k);
    const auto& [number, needs] = measure_of(kind);
    text += row({"`" + support::to_string(kind) + "`", number, in_code(needs)});
  }
  return text + "\n";
}

std::string takes(const SettingKey& key) {
  if (key.key == "problem") return "a word of `mpmvv list problems`";
  if (key.member && key.member->is_flag) return "true or false";
  const auto words = settings::words_of_key(key.key);
  if (!words.empty()) return in_code(words);
  if (!key.member) return "number";
  if (std::holds_alternative<std::string>(key.member->value({}))) return "a word ([adapters.md](adapters.md))";
  return std::holds_alternative<double>(key.member->value({})) ? "number" : "whole number";
}

std::string settings_section() {
  std::string text = "## Settings\n\n" +
                     paragraph(
                         "What a case is made of: the options of `mpmvv run`, with `_` for `-`. The words are "
                         "explained in [theory.md](theory.md), the problems in [problems.md](problems.md).") +
                     "| key | takes | without it | meaning |\n|---|---|---|---|\n";
  for (const SettingKey& key : settings::setting_keys())
    text += row({"`" + key.key + "`", takes(key), or_required(without(key)), key.meaning});
  return text + row({"`param`", "a table of numbers", "the problem's", "physical values of the problem"});
}

}  // namespace

std::string without(const SettingKey& key) {
  if (key.absent) return key.absent->reference;
  const std::string value = cases::text_of(key.member->value({}));
  return settings::words_of_key(key.key).empty() ? value : "`" + value + "`";
}

std::vector<std::string> keys_of(Criterion::Kind kind) {
  std::vector<std::string> keys{"claim", "statement", "measure", "reason"};
  const std::vector<std::string> needs = measure_of(kind).needs;
  keys.insert(keys.end(), needs.begin(), needs.end());
  if (!needs.empty()) keys.insert(keys.end(), {"at_least", "at_most"});  // there is a number
  return keys;
}

std::string study_file_reference() {
  std::string text = introduction;
  for (const FileTable& table : file_tables()) text += section(table);
  return text + measures() + settings_section();
}

}  // namespace mpmvv::plan
