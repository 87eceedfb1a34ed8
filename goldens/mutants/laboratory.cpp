#include "goldens/mutants/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/case.hpp"
#include "studies/error.hpp"
#include "studies/file.hpp"

namespace mpmvv {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file) {
  if (auto content = read_file(file)) return std::move(*content);
  throw UsageError(fmt::format("cannot read '{}' (a file of the tree)", file.string()));
}

}  // namespace

bool is_within(const std::string& file, const std::string& part) {
  return file == part || file.starts_with(part + "/");
}

Laboratory::Laboratory(const fs::path& source, const fs::path& work, const std::vector<std::string>& parts)
    : work_(fs::absolute(work).lexically_normal()) {
  const std::string place = work_.lexically_relative(fs::absolute(source).lexically_normal()).string();
  for (const std::string& part : parts) {
    if (!fs::exists(source / part))
      throw UsageError(fmt::format("no '{}' in '{}' (the top of the source tree)", part, source.string()));
    if (is_within(place, part))
      throw UsageError(fmt::format("work folder '{}' lies in the tree's '{}' (another folder)", work.string(), part));
  }
  lock();
  for (const std::string& part : parts) copy(source, part);
  std::ranges::sort(files_);
  remove_strays();
}

std::string Laboratory::text(const std::string& file) const {
  const auto original = originals_.find(file);
  return original != originals_.end() && original->second ? *original->second : content_of(tree() / file);
}

std::string Laboratory::digest(const std::function<bool(const std::string&)>& is_wanted) const {
  std::string all;
  for (const std::string& file : files_)
    if (is_wanted(file)) all += fmt::format("{} {}\n", file, fingerprint(text(file)));
  return fingerprint(all);
}

void Laboratory::apply(const Edit& edit) {
  apply({{edit.file, edited(edit, text(edit.file))}});
}

/// What is the same before and after is not written: it would be compiled anew.
void Laboratory::apply(const std::map<std::string, std::string>& texts) {
  Originals originals;
  for (const auto& [file, changed] : texts)
    originals[file] = std::ranges::binary_search(files_, file) ? std::optional(text(file)) : std::nullopt;
  for (const auto& [file, original] : originals_)
    if (!texts.contains(file)) restore(file, original);
  for (const auto& [file, changed] : texts) write_if_changed(tree() / file, changed);
  originals_ = std::move(originals);
}

void Laboratory::undo() {
  apply(std::map<std::string, std::string>{});
}

void Laboratory::restore(const std::string& file, const std::optional<std::string>& original) const {
  if (original)
    write_if_changed(tree() / file, *original);
  else
    fs::remove(tree() / file);
}

ProcessEnd Laboratory::run(const std::vector<std::string>& command, std::chrono::seconds limit,
                           const std::map<std::string, std::string>& environment) const {
  ProcessEnd end = run_process(command, tree(), environment, limit);
  if (end.start_error != 0)
    throw UsageError(fmt::format("cannot start '{}' in {} (a program that is installed or was built)", command.front(),
                                 tree().string()));
  return end;
}

void Laboratory::lock() {
  make_folder(work_);
  write_if_changed(work_ / "lock", "One process at a time works here.\n");
  lock_ = boost::interprocess::file_lock((work_ / "lock").c_str());
  if (!lock_.try_lock())
    throw UsageError(fmt::format("another process works in '{}' (wait for it, or another folder)", work_.string()));
}

void Laboratory::copy(const fs::path& source, const std::string& part) {
  const auto copy_file = [&](const std::string& file) {
    make_folder((tree() / file).parent_path());
    write_if_changed(tree() / file, content_of(source / file));
    files_.push_back(file);
  };
  if (!fs::is_directory(source / part)) return copy_file(part);
  for (const auto& entry : fs::recursive_directory_iterator(source / part))
    if (entry.is_regular_file()) copy_file(entry.path().lexically_relative(source).generic_string());
}

void Laboratory::remove_strays() const {
  std::vector<fs::path> strays;
  for (const auto& entry : fs::recursive_directory_iterator(tree()))
    if (entry.is_regular_file() &&
        !std::ranges::binary_search(files_, entry.path().lexically_relative(tree()).generic_string()))
      strays.push_back(entry.path());
  for (const fs::path& stray : strays) fs::remove(stray);
}

}  // namespace mpmvv
