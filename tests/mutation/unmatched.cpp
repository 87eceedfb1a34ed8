#include "tests/mutation/unmatched.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "tests/mutation/anchor.hpp"
#include "tests/mutation/operators.hpp"

namespace mpmvv::mutation {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const Sources& sources) {
  std::vector<std::string> files;
  for (const auto& [file, text] : sources) files.push_back(file);
  return files;
}

/// The code most like this, in the files of that name or else in any; empty where more than half of the tokens differ.
std::string nearest(const std::string& code, const std::string& file, const Sources& sources) {
  std::optional<Likeness> best;
  std::string where;
  const auto look_in = [&](const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      const Likeness found = most_like(code, sources.at(path));
      if (2 * found.differing > found.tokens || (best && best->differing <= found.differing)) continue;
      best = found;
      where = path;
    }
  };
  look_in(sources_named(file, files_of(sources)));
  if (!best) look_in(files_of(sources));
  if (!best) return "";
  const auto& [begin, end] = best->region;
  return fmt::format("{}:{} differs in {} of {} tokens: {}", where, line_of(sources.at(where), begin), best->differing,
                     best->tokens, lines_at(sources.at(where), begin, end - begin));
}

std::optional<Unmatched> judge(const Mistake& mistake, const Sources& sources) {
  try {
    const std::string file = file_of(mistake, files_of(sources));
    edit_of(mistake, file, sources.at(file));
    return std::nullopt;
  } catch (const support::UsageError& e) {
    return Unmatched{e.what(), nearest(mistake.find, mistake.file, sources)};
  }
}

bool is_of(const Explanation& explanation, const Edit& edit, const std::string& text) {
  return explanation.is_of({.name = "",
                            .kind = Mutant::Kind::random,
                            .what = "",
                            .file = edit.file,
                            .before = lines_at(text, edit.at, edit.before.size()),
                            .after = lines_at(edited(edit, text), edit.at, edit.after.size())});
}

std::optional<Unmatched> judge(const Explanation& explanation, const Sources& sources) {
  for (const std::string& file : mutated_files(sources_named(explanation.file, files_of(sources)))) {
    const std::string& text = sources.at(file);
    const auto edits = mutations_of(file, text);
    if (std::ranges::any_of(edits, [&](const Edit& edit) { return is_of(explanation, edit, text); }))
      return std::nullopt;
  }
  return Unmatched{fmt::format("no mutation of {} makes '{}' of '{}' in {} (a line as it stands there; where it has "
                               "changed, see whether the reason still holds)",
                               explanation.file, explanation.after, explanation.before, explanation.where),
                   nearest(explanation.before, explanation.file, sources)};
}

}  // namespace

Sources read_sources(const fs::path& top) {
  Sources sources;
  for (const char* folder : {"mms", "solver", "studies", "goldens", "reports", "cli"}) {
    if (!fs::is_directory(top / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".hpp" || extension == ".cpp")
        sources[entry.path().lexically_relative(top).generic_string()] =
            support::require_file(entry.path(), "a source of the program");
    }
  }
  return sources;
}

std::vector<Unmatched> unmatched(const std::vector<Mistake>& mistakes, const std::vector<Explanation>& explanations,
                                 const Sources& sources) {
  std::vector<Unmatched> all;
  const auto add = [&](const auto& entries) {
    for (const auto& entry : entries)
      if (auto wrong = judge(entry, sources)) all.push_back(std::move(*wrong));
  };
  add(mistakes);
  add(explanations);
  return all;
}

}  // namespace mpmvv::mutation
