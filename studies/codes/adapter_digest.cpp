#include "studies/codes/adapter_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "studies/cases/case.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;

namespace {

/// Returns the files in the adapter's folder, as paths in it, without those that decide no run: its studies, its
/// goldens, and what Python compiles.
std::vector<std::string> files_in(const fs::path& folder) {
  constexpr std::array idle{"studies", "goldens", "__pycache__"};
  std::vector<std::string> files;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied);
  for (; entry != fs::recursive_directory_iterator(); ++entry) {
    if (std::ranges::find(idle, entry->path().filename()) != idle.end())
      entry.disable_recursion_pending();
    else if (entry->is_regular_file())
      files.push_back(entry->path().lexically_relative(folder).string());
  }
  std::ranges::sort(files);
  return files;
}

/// Whether a name may stand for the file, or for a folder that it lies in. Fields in the name stand for any text.
bool may_name(const std::string& name, const std::string& file) {
  const std::string path = file + '/';
  const auto fields = name.find("{{"), behind = name.rfind("}}");
  if (fields == std::string::npos) return path.starts_with(name.empty() || name.ends_with('/') ? name : name + '/');
  const std::string end = behind == std::string::npos ? "" : name.substr(behind + 2);
  return path.starts_with(name.substr(0, fields)) && path.find(end + '/', fields) != std::string::npos;
}

/// Returns the contents of the files that the rest of a word, behind `{{adapter}}/`, names. If it is not the name of a
/// file as it stands, the name ends before a blank, a quotation mark or another character that may follow it.
std::string contents_named(const std::string& rest, const fs::path& folder) {
  if (const auto content = support::read_file(folder / rest)) return *content;
  const std::string name = rest.substr(0, rest.find_first_of(" \t\n\"'`,:;<>|&()"));
  std::string contents;
  for (const std::string& file : files_in(folder))
    if (may_name(name, file)) contents += fmt::format("\n{}\n{}", file, support::read_file(folder / file).value_or(""));
  return contents;
}

/// Returns what stands behind each `{{adapter}}/` of a word, which may have blanks in it, a third brace or an &.
std::vector<std::string> behind_adapter(std::string_view word) {
  constexpr std::string_view field = "adapter", blanks = " \t\n\v\f\r";
  std::vector<std::string> rests;
  for (auto at = word.find(field); at != std::string_view::npos; at = word.find(field, at + field.size())) {
    std::string_view before = word.substr(0, at), rest = word.substr(at + field.size());
    before = before.substr(0, before.find_last_not_of(blanks) + 1);
    if (!before.ends_with("{{") && !before.ends_with("{{&")) continue;
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    for (const std::string_view end : {"}}/", "}}}/"})
      if (rest.starts_with(end)) rests.emplace_back(rest.substr(end.size()));
  }
  return rests;
}

/// Returns the contents of the files in the adapter's folder that a command names, as in `{{adapter}}/convert.py`.
std::string files_named_by(const std::vector<std::string>& command, const fs::path& folder) {
  std::string contents;
  for (const std::string& word : command)
    for (const std::string& rest : behind_adapter(word)) contents += contents_named(rest, folder);
  return contents;
}

}  // namespace

std::string adapter_digest(const std::string& text, const Adapter& adapter) {
  std::string all = text;
  for (const InputFile& input : adapter.inputs) all += fmt::format("\n{}\n{}", input.file, input.text);
  all += files_named_by(adapter.command, adapter.folder);
  for (const auto& command : adapter.output.convert) all += files_named_by(command, adapter.folder);
  return cases::fingerprint(all);
}

}  // namespace mpmvv::codes
