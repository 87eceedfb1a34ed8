#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <fstream>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cli {

namespace {

namespace fs = std::filesystem;

bool is_in(const fs::path& input, const fs::path& output) {
  std::error_code absent;
  const fs::path whole = fs::canonical(input, absent);
  if (absent) return false;
  for (fs::path part = whole;; part = part.parent_path()) {
    if (fs::equivalent(part, output, absent)) return true;
    if (part == whole.root_path()) return false;
  }
}

std::vector<fs::path> with_content(const fs::path& input) {
  std::vector<fs::path> all{input};
  std::error_code no_folder;
  for (const auto& entry : fs::directory_iterator(input, no_folder)) all.push_back(entry.path());
  return all;
}

[[noreturn]] void refuse(const std::string& option, const fs::path& output, const fs::path& file) {
  std::error_code unknown;
  if (fs::is_directory(output, unknown))
    throw support::UsageError(
        fmt::format("{} {} is a folder that holds '{}', which this command reads (a folder or file "
                    "of its own)",
                    option, output.string(), file.string()));
  throw support::UsageError(fmt::format("{} {} would overwrite '{}', which this command reads (another place)", option,
                                        output.string(), file.string()));
}

/// Whether it is a pipe that the caller gave this program, as /dev/stdout before a `|` and >(gzip > file) are: that one
/// is read already.
bool is_open(const fs::path& pipe) {
  struct stat wanted = {}, open = {};
  if (stat(pipe.c_str(), &wanted) != 0) return false;
  std::error_code unknown;
  for (const auto& each : fs::directory_iterator("/proc/self/fd", unknown))
    if (stat(each.path().c_str(), &open) == 0 && open.st_dev == wanted.st_dev && open.st_ino == wanted.st_ino)
      return true;
  return false;
}

/// The first bytes of a file, at most so many. Nothing of what is no file: a terminal would wait for somebody to type.
std::string beginning_of(const fs::path& file, std::size_t bytes) {
  if (std::error_code unknown; !fs::is_regular_file(file, unknown)) return "";
  std::string begin(bytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), static_cast<std::streamsize>(bytes));
  begin.resize(static_cast<std::size_t>(stream.gcount()));
  return begin;
}

/// How many bytes at the beginning of a text tell its kind: in XML those up to the name of the root, else those of a
/// table's first columns.
std::size_t telling_bytes(const std::string& text) {
  constexpr std::size_t of_table = 5;
  if (!text.starts_with("<?xml")) return of_table;
  const std::size_t root = text.find('<', text.find("?>"));
  return std::min(text.find_first_of(" >", root), text.size());
}

}  // namespace

void require_apart(const std::string& option, const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs)
    for (const fs::path& file : with_content(input))
      if (is_in(file, output)) refuse(option, output, file);
}

void require_apart(const std::string& option, const fs::path& output, const std::string& other_option,
                   const fs::path& other_output) {
  std::error_code absent;
  const auto whole = [&absent](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path), absent); };
  if (whole(output) == whole(other_output) || fs::equivalent(output, other_output, absent))
    throw support::UsageError(
        fmt::format("{} and {} both write '{}' (a file each)", option, other_option, other_output.string()));
}

void require_writable_at_once(const std::string& option, const fs::path& file) {
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  const bool is_taken = !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status) ||
                        fs::is_character_file(status) || (fs::is_fifo(status) && is_open(file));
  if (!is_taken)
    throw support::UsageError(
        fmt::format("{} {} is a pipe, a socket or a disk (a file, or /dev/stdout)", option, file.string()));
}

void write_output(const std::string& option, const fs::path& file, const std::string& text) {
  require_writable_at_once(option, file);
  const std::string begin = beginning_of(file, telling_bytes(text));
  if (!begin.empty() && !text.starts_with(begin))
    throw support::UsageError(fmt::format(
        "{} {} is there, and is not what this command writes (another name, or remove it)", option, file.string()));
  support::write_if_changed(file, text);
}

}  // namespace mpmvv::cli
