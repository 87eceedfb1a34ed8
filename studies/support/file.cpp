#include "studies/support/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "studies/support/error.hpp"

namespace mpmvv::support {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const fs::path& file) {
  if (std::error_code absent; !fs::is_regular_file(file, absent)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  try {
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {  // the system opens it, but does not give what is in it
    return std::nullopt;
  }
}

std::string require_file(const fs::path& file, const std::string& wanted) {
  if (auto content = read_file(file)) return std::move(*content);
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  const std::string why = fs::is_directory(status) ? "a directory"
                          : fs::exists(status) && !fs::is_regular_file(status)
                              ? "a pipe or a device, which cannot be read again"
                          : failed ? failed.message()
                                   : "it may not be read";
  throw UsageError(fmt::format("cannot read '{}': {} ({})", file.string(), why, wanted));
}

namespace {

[[noreturn]] void refuse_to_write(const fs::path& file, const std::string& why) {
  throw WriteError(fmt::format("cannot write {} ({}); name a file in a folder that is there and can be written",
                               file.string(), why));
}

/// Writes `place`, and deletes it again if it could not be written whole. Messages name `wanted`, the file that was
/// asked for.
void write(const fs::path& place, const std::string& content, const fs::path& wanted) {
  std::ofstream out(place, std::ios::binary);
  out << content << std::flush;
  if (out) return;
  const std::string why = std::strerror(errno);
  std::error_code ignored;
  if (fs::is_regular_file(place, ignored)) fs::remove(place, ignored);
  refuse_to_write(wanted, why);
}

/// What a symbolic link points to, and so on to the end.
fs::path end_of_links(fs::path file) {
  std::error_code absent;
  while (fs::is_symlink(file, absent)) file = file.parent_path() / fs::read_symlink(file, absent);
  return file;
}

/// Makes an empty file in the same folder under a name that nobody else has.
fs::path new_file_beside(const fs::path& file, const fs::path& wanted) {
  for (int k = 0;; ++k) {
    fs::path part = fmt::format("{}.{}-{}.part", file.string(), getpid(), k);
    const int descriptor = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) refuse_to_write(wanted, std::strerror(errno));
    close(descriptor);
    return part;
  }
}

}  // namespace

bool write_if_changed(const fs::path& file, const std::string& content) {
  if (read_file(file) == content) return false;
  std::error_code failed;
  const bool is_there = fs::exists(file, failed);
  if (failed) refuse_to_write(file, failed.message());
  if (is_there && !fs::is_regular_file(file, failed) && !fs::is_directory(file, failed)) {
    write(file, content, file);  // a pipe or a device is not replaced
    return true;
  }
  const fs::path target = end_of_links(file), part = new_file_beside(target, file);
  const fs::file_status replaced = fs::status(target, failed);
  const bool has_permissions = fs::is_regular_file(replaced);
  if (has_permissions) fs::permissions(part, fs::perms::owner_read | fs::perms::owner_write, failed);
  write(part, content, file);
  if (has_permissions) fs::permissions(part, replaced.permissions(), failed);
  fs::rename(part, target, failed);
  if (!failed) return true;
  const std::string why = failed.message();
  fs::remove(part, failed);
  refuse_to_write(file, why);
}

bool is_file_stem(const std::string& text) {
  constexpr std::size_t longest = 100;  // the names of a report's files add to it
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._+-";
  return !text.empty() && text.size() <= longest && text.front() != '.' && text.front() != '-' &&
         text.find_first_not_of(letters) == std::string::npos;
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::rename(from, to, failed);
  if (failed)
    throw WriteError(
        fmt::format("cannot write {} ({}); name a folder that can be written", to.string(), failed.message()));
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder))
    throw WriteError(fmt::format("cannot make the folder {} ({}); name one that can be written", folder.string(),
                                 failed ? failed.message() : "a file is in its place"));
}

}  // namespace mpmvv::support
