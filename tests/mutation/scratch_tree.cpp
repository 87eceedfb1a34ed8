#include "tests/mutation/scratch_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/trim.hpp>
#include <sstream>

#include "studies/cases/case.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::mutation {

using cases::fingerprint;
using support::make_folder;
using support::ProcessEnd;
using support::read_file;
using support::run_process;
using support::UsageError;
using support::write_if_changed;

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file) {
  if (auto content = support::read_file(file)) return std::move(*content);
  throw support::UsageError(fmt::format("cannot read '{}' (a file of the tree)", file.string()));
}

/// The path without links, so that two names of one place are equal.
fs::path resolved(const fs::path& place) {
  std::error_code failed;
  const fs::path path = fs::weakly_canonical(fs::absolute(place), failed);
  if (failed)
    throw support::UsageError(
        fmt::format("cannot follow '{}': {} (name another folder)", place.string(), failed.message()));
  return path;
}

bool is_code(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

/// The lines of C++ code without indentation, without those that are empty and without comments. A line with a
/// quotation mark before its comment stays whole, because there `//` may be part of a text. So does all of a text that
/// has a raw string, a `/* */` comment or a line that the next one continues.
std::string code_lines(const std::string& text) {
  const std::array<std::string, 3> beyond_lines{"R\"", "/*", "\\\n"};
  if (std::ranges::any_of(beyond_lines, [&](const std::string& mark) { return text.find(mark) != std::string::npos; }))
    return text;
  std::string code;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t comment = line.find("//");
    if (comment < line.find('"')) line.resize(comment);
    boost::algorithm::trim(line);
    if (!line.empty()) code += line + "\n";
  }
  return code;
}

constexpr const char* marker_name = "mpmvv-scratch";
constexpr const char* marker_text =
    "A scratch folder of `./run mutants`, one process at a time: what lies here is replaced.\n";

/// Whether the folder has the program's own marker, a file and not a link to one.
bool is_marked(const fs::path& work) {
  const fs::path marker = work / marker_name;
  return fs::is_regular_file(fs::symlink_status(marker)) && support::read_file(marker) == marker_text;
}

/// Throws unless the folder is absent, empty or marked: the program empties no folder that it has not made.
void require_scratch(const fs::path& work) {
  if (!fs::exists(work)) return;
  if (!fs::is_directory(work))
    throw support::UsageError(fmt::format("work folder '{}' is a file (name a folder)", work.string()));
  if (!fs::is_empty(work) && !is_marked(work))
    throw support::UsageError(
        fmt::format("work folder '{}' is neither empty nor a scratch folder of this program, with its file '{}' "
                    "(name another folder, or a new one)",
                    work.string(), marker_name));
}

/// Throws on a link: the program makes none in a scratch folder, and a link leads out of it.
void require_no_link(const fs::path& place) {
  if (fs::is_symlink(place))
    throw support::UsageError(
        fmt::format("'{}' in a work folder is a link (take it away, or name another folder)", place.string()));
}

}  // namespace

bool is_within(const std::string& file, const std::string& part) {
  return file == part || file.starts_with(part + "/");
}

ScratchTree::ScratchTree(const fs::path& source, const fs::path& work, const std::vector<std::string>& parts)
    : work_(resolved(work)) {
  const fs::path top = resolved(source), way = top.lexically_relative(work_);
  const std::string place = work_.lexically_relative(top).string();
  if (*way.begin() != "..")
    throw support::UsageError(fmt::format("work folder '{}' holds the source tree (another folder)", work_.string()));
  for (const std::string& part : parts) {
    if (!fs::exists(source / part))
      throw support::UsageError(fmt::format("no '{}' in '{}' (the top of the source tree)", part, source.string()));
    if (is_within(place, part))
      throw support::UsageError(
          fmt::format("work folder '{}' lies in the tree's '{}' (another folder)", work.string(), part));
  }
  require_scratch(work_);
  for (const fs::path& folder : {tree(), builds(), build()}) require_no_link(folder);
  for (const fs::path& path : copied()) require_no_link(path);
  lock();
  for (const std::string& part : parts) copy(source, part);
  std::ranges::sort(files_);
  remove_strays();
}

std::string ScratchTree::text(const std::string& file) const {
  const auto original = originals_.find(file);
  return original != originals_.end() && original->second ? *original->second : content_of(tree() / file);
}

std::string ScratchTree::digest(const std::function<bool(const std::string&)>& is_wanted) const {
  std::string all;
  for (const std::string& file : files_)
    if (is_wanted(file)) {
      const std::string content = text(file);
      all += fmt::format("{} {}\n", file, fingerprint(is_code(file) ? code_lines(content) : content));
    }
  return fingerprint(all);
}

void ScratchTree::apply(const Edit& edit) {
  apply({{edit.file, edited(edit, text(edit.file))}});
}

/// A file that is the same before and after is not written, as it would be compiled again.
void ScratchTree::apply(const std::map<std::string, std::string>& texts) {
  Originals originals;
  for (const auto& [file, changed] : texts)
    originals[file] = std::ranges::binary_search(files_, file) ? std::optional(text(file)) : std::nullopt;
  for (const auto& [file, original] : originals_)
    if (!texts.contains(file)) restore(file, original);
  for (const auto& [file, changed] : texts) support::write_if_changed(tree() / file, changed);
  originals_ = std::move(originals);
}

void ScratchTree::undo() {
  apply(std::map<std::string, std::string>{});
}

void ScratchTree::restore(const std::string& file, const std::optional<std::string>& original) const {
  if (original)
    support::write_if_changed(tree() / file, *original);
  else
    fs::remove(tree() / file);
}

support::ProcessEnd ScratchTree::run(const std::vector<std::string>& command, std::chrono::seconds limit,
                                     const std::map<std::string, std::string>& environment,
                                     const std::stop_token& stop) const {
  support::ProcessEnd end = support::run_process(command, tree(), environment, limit, std::nullopt, stop);
  if (end.start_error != 0)
    throw support::UsageError(fmt::format("cannot start '{}' in {} (a program that is installed or was built)",
                                          command.front(), tree().string()));
  return end;
}

void ScratchTree::lock() {
  support::make_folder(work_);
  support::write_if_changed(work_ / marker_name, marker_text);
  lock_ = boost::interprocess::file_lock((work_ / marker_name).c_str());
  if (!lock_.try_lock())
    throw support::UsageError(
        fmt::format("another process works in '{}' (wait for it, or another folder)", work_.string()));
}

void ScratchTree::copy(const fs::path& source, const std::string& part) {
  const auto copy_file = [&](const std::string& file) {
    support::make_folder((tree() / file).parent_path());
    support::write_if_changed(tree() / file, content_of(source / file));
    fs::permissions(tree() / file, fs::status(source / file).permissions());  // the tree has programs, too
    files_.push_back(file);
  };
  if (!fs::is_directory(source / part)) return copy_file(part);
  for (const auto& entry : fs::recursive_directory_iterator(source / part))
    if (entry.is_regular_file()) copy_file(entry.path().lexically_relative(source).generic_string());
}

std::vector<fs::path> ScratchTree::copied() const {
  std::vector<fs::path> paths;
  if (!fs::exists(tree())) return paths;
  for (auto entry = fs::recursive_directory_iterator(tree()); entry != end(entry); ++entry)
    if (entry->path() == builds())
      entry.disable_recursion_pending();
    else
      paths.push_back(entry->path());
  return paths;
}

void ScratchTree::remove_strays() const {
  for (const fs::path& path : copied())
    if (fs::is_regular_file(path) &&
        !std::ranges::binary_search(files_, path.lexically_relative(tree()).generic_string()))
      fs::remove(path);
}

}  // namespace mpmvv::mutation
