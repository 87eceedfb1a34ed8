#include "tests/mutation/mistake.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"
#include "tests/mutation/anchor.hpp"

namespace mpmvv::mutation {

using support::TomlTable;
using support::UsageError;

namespace {

[[noreturn]] void refuse(const std::string& wrong, const std::string& where, const std::string& right) {
  throw support::UsageError(fmt::format("{} in {} ({})", wrong, where, right));
}

std::string filled(const support::TomlTable& table, const std::string& key) {
  const std::string text = table.text(key);
  if (text.find_first_not_of(" \t\n") == std::string::npos)
    refuse(fmt::format("'{}' is blank", key), table.where(key), "a text");
  return text;
}

std::string kebab_name(const support::TomlTable& table) {
  const std::string name = filled(table, "name");
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
    refuse(fmt::format("name '{}'", name), table.where("name"), "lower-case letters, digits and '-'");
  return name;
}

Mistake read_mistake(const support::TomlTable& table) {
  table.allow_only({"name", "what", "file", "function", "find", "replace", "equivalent"});
  Mistake mistake{.name = kebab_name(table),
                  .what = filled(table, "what"),
                  .file = filled(table, "file"),
                  .function = table.has("function") ? filled(table, "function") : "",
                  .find = filled(table, "find"),
                  .replace = table.text("replace"),
                  .reason = table.has("equivalent") ? filled(table, "equivalent") : "",
                  .where = table.where()};
  if (mistake.find == mistake.replace)
    refuse(fmt::format("mistake '{}' changes nothing", mistake.name), mistake.where, "another 'replace' than 'find'");
  return mistake;
}

}  // namespace

std::vector<Mistake> read_mistakes(const std::filesystem::path& file) {
  const support::TomlTable document = support::TomlTable::read(file);
  document.allow_only({"mistake"});
  std::vector<Mistake> mistakes;
  std::set<std::string> names;
  for (const support::TomlTable& table : document.tables("mistake")) {
    mistakes.push_back(read_mistake(table));
    if (!names.insert(mistakes.back().name).second)
      refuse(fmt::format("a second mistake '{}'", mistakes.back().name), mistakes.back().where, "another name");
  }
  if (mistakes.empty()) refuse("no mistake", file.string(), "at least one [[mistake]]");
  return mistakes;
}

std::string file_of(const Mistake& mistake, const std::vector<std::string>& files) {
  const std::vector<std::string> named = sources_named(mistake.file, files);
  if (named.empty())
    refuse(fmt::format("no source '{}' for mistake '{}'", mistake.file, mistake.name), mistake.where,
           "the name of a .hpp or .cpp file of the program");
  if (named.size() > 1)
    refuse(fmt::format("'{}' of mistake '{}' is {}", mistake.file, mistake.name, fmt::join(named, " and ")),
           mistake.where, "its folder's name before it");
  return named.front();
}

Edit edit_of(const Mistake& mistake, const std::string& file, const std::string& text) {
  std::vector<Region> found = occurrences_of(mistake.find, text);
  std::string place = file;
  if (!mistake.function.empty()) {
    const std::vector<Region> definitions = definitions_of(mistake.function, text);
    if (definitions.empty())
      refuse(fmt::format("no function or class '{}' of mistake '{}' in {}", mistake.function, mistake.name, file),
             mistake.where, "one that is defined there");
    std::erase_if(found, [&](const Region& region) {
      return std::ranges::none_of(definitions, [&](const Region& d) { return d.holds(region); });
    });
    place = fmt::format("'{}' of {}", mistake.function, file);
  }
  if (found.empty())
    refuse(fmt::format("'find' of mistake '{}' occurs nowhere in {}", mistake.name, place), mistake.where,
           "code that occurs there exactly once");
  if (found.size() > 1)
    refuse(fmt::format("'find' of mistake '{}' occurs in {} on lines {} and {}", mistake.name, place,
                       line_of(text, found[0].begin), line_of(text, found[1].begin)),
           mistake.where, "code that occurs there exactly once, with more of it or a 'function'");
  const Region only = found.front();
  return {file, only.begin, text.substr(only.begin, only.end - only.begin), mistake.replace};
}

std::vector<Explanation> read_explanations(const std::filesystem::path& file) {
  const support::TomlTable document = support::TomlTable::read(file);
  document.allow_only({"survivor"});
  std::vector<Explanation> explanations;
  for (const support::TomlTable& table : document.tables("survivor")) {
    table.allow_only({"file", "before", "after", "reason"});
    explanations.push_back({filled(table, "file"), filled(table, "before"), filled(table, "after"),
                            filled(table, "reason"), table.where()});
  }
  return explanations;
}

bool Explanation::is_of(const Mutant& mutant) const {
  return mutant.kind == Mutant::Kind::random && names(file, mutant.file) && is_same_code(mutant.before, before) &&
         is_same_code(mutant.after, after);
}

Reasons::Reasons(const std::filesystem::path& folder) {
  if (const auto file = folder / "planted.toml"; std::filesystem::exists(file)) planted_ = read_mistakes(file);
  if (const auto file = folder / "explained.toml"; std::filesystem::exists(file)) explained_ = read_explanations(file);
}

std::string Reasons::of(const Mutant& mutant) const {
  if (mutant.kind == Mutant::Kind::planted)
    for (const Mistake& mistake : planted_)
      if (mutant.name == mistake.name) return mistake.reason;
  for (const Explanation& explanation : explained_)
    if (explanation.is_of(mutant)) return explanation.reason;
  return "";
}

std::vector<Mutant> Reasons::reviewed(std::vector<Mutant> mutants) const {
  if (mutants.empty() || planted_.empty()) return mutants;
  std::vector<Mutant> all;
  const auto is_planted = [](const Mutant& m) { return m.kind == Mutant::Kind::planted; };
  std::ranges::remove_copy_if(mutants, std::back_inserter(all), is_planted);
  for (const Mistake& mistake : planted_) {
    const auto tried =
        std::ranges::find_if(mutants, [&](const Mutant& m) { return is_planted(m) && m.name == mistake.name; });
    all.push_back(tried != mutants.end() ? *tried
                                         : Mutant{.name = mistake.name, .what = mistake.what, .file = mistake.file});
  }
  for (Mutant& mutant : all) mutant.reason = of(mutant);
  return all;
}

}  // namespace mpmvv::mutation
