#include "studies/codes/adapter_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

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

/// Returns the contents of the files in the adapter's folder that a command names, as in `{{adapter}}/convert.py`.
std::string files_named_by(const std::vector<std::string>& command, const fs::path& folder) {
  static const std::regex prefix(R"(\{\{[{&]?\s*adapter\s*\}?\}\}/)");
  std::string contents;
  for (const std::string& word : command)
    for (std::sregex_iterator named(word.begin(), word.end(), prefix), end; named != end; ++named)
      contents += contents_named(named->suffix(), folder);
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
