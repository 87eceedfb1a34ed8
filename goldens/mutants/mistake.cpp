#include "goldens/mutants/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv {

using support::TomlTable;
using support::UsageError;

namespace {

[[noreturn]] void refuse(const std::string& wrong, const std::string& where, const std::string& right) {
  throw UsageError(fmt::format("{} in {} ({})", wrong, where, right));
}

std::string filled(const TomlTable& table, const std::string& key) {
  const std::string text = table.text(key);
  if (text.find_first_not_of(" \t\n") == std::string::npos)
    refuse(fmt::format("'{}' is blank", key), table.where(key), "a text");
  return text;
}

std::string kebab_name(const TomlTable& table) {
  const std::string name = filled(table, "name");
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
    refuse(fmt::format("name '{}'", name), table.where("name"), "lower-case letters, digits and '-'");
  return name;
}

/// The reason of what nothing can show; empty for the others.
std::string silence(const TomlTable& table) {
  if (!table.has("shows")) {
    if (table.has("reason")) refuse("'reason' without 'shows'", table.where("reason"), "shows = \"nothing\" beside it");
    return {};
  }
  if (const std::string shows = table.text("shows"); shows != "nothing")
    refuse(fmt::format("shows = '{}'", shows), table.where("shows"), "nothing, or no such key");
  return filled(table, "reason");
}

Mistake read_mistake(const TomlTable& table) {
  table.allow_only({"name", "what", "file", "find", "replace", "shows", "reason"});
  Mistake mistake{kebab_name(table),     filled(table, "what"), filled(table, "file"), filled(table, "find"),
                  table.text("replace"), silence(table),        table.where()};
  if (mistake.find == mistake.replace)
    refuse(fmt::format("mistake '{}' changes nothing", mistake.name), mistake.where, "another 'replace' than 'find'");
  return mistake;
}

}  // namespace

std::vector<Mistake> read_mistakes(const std::filesystem::path& file) {
  const TomlTable document = TomlTable::read(file);
  document.allow_only({"mistake"});
  std::vector<Mistake> mistakes;
  std::set<std::string> names;
  for (const TomlTable& table : document.tables("mistake")) {
    mistakes.push_back(read_mistake(table));
    if (!names.insert(mistakes.back().name).second)
      refuse(fmt::format("a second mistake '{}'", mistakes.back().name), mistakes.back().where, "another name");
  }
  if (mistakes.empty()) refuse("no mistake", file.string(), "at least one [[mistake]]");
  return mistakes;
}

Edit edit_of(const Mistake& mistake, const std::string& text) {
  const std::size_t at = text.find(mistake.find);
  const auto reject = [&](const char* how_often) {
    refuse(fmt::format("'find' of mistake '{}' occurs {} in {}", mistake.name, how_often, mistake.file), mistake.where,
           "a text that occurs there exactly once");
  };
  if (at == std::string::npos) reject("nowhere");
  if (text.find(mistake.find, at + 1) != std::string::npos) reject("more than once");
  return {mistake.file, at, mistake.find, mistake.replace};
}

std::vector<Explanation> read_explanations(const std::filesystem::path& file) {
  const TomlTable document = TomlTable::read(file);
  document.allow_only({"survivor"});
  std::vector<Explanation> explanations;
  for (const TomlTable& table : document.tables("survivor")) {
    table.allow_only({"file", "before", "after", "reason"});
    explanations.push_back({filled(table, "file"), filled(table, "before"), filled(table, "after"),
                            filled(table, "reason"), table.where()});
  }
  return explanations;
}

bool Explanation::is_of(const Mutant& mutant) const {
  return mutant.kind == Mutant::Kind::random && mutant.file == file && mutant.before == before && mutant.after == after;
}

std::vector<Mutant> reviewed(std::vector<Mutant> mutants, const std::filesystem::path& folder) {
  if (mutants.empty() || !std::filesystem::exists(folder / "planted.toml")) return mutants;
  std::vector<Mutant> all;
  const auto is_planted = [](const Mutant& m) { return m.kind == Mutant::Kind::planted; };
  std::ranges::remove_copy_if(mutants, std::back_inserter(all), is_planted);
  for (const Mistake& mistake : read_mistakes(folder / "planted.toml")) {
    const auto tried =
        std::ranges::find_if(mutants, [&](const Mutant& m) { return is_planted(m) && m.name == mistake.name; });
    all.push_back(tried != mutants.end() ? *tried
                                         : Mutant{.name = mistake.name, .what = mistake.what, .file = mistake.file});
  }
  const Reasons reasons(folder);
  for (Mutant& mutant : all) mutant.reason = reasons.of(mutant);
  return all;
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

void Reasons::check(const std::vector<Mutant>& mutants) const {
  for (const Explanation& explanation : explained_)
    if (std::ranges::none_of(mutants, [&](const Mutant& mutant) { return explanation.is_of(mutant); }))
      refuse(
          fmt::format("no mutation of {} makes '{}' of '{}'", explanation.file, explanation.after, explanation.before),
          explanation.where, "a line as it stands there; where it has changed, see whether the reason still holds");
}

}  // namespace mpmvv
