#include "studies/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "studies/error.hpp"

namespace mpmvv {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) return std::nullopt;
  return content;
}

bool write_if_changed(const fs::path& file, const std::string& content) {
  if (read_file(file) == content) return false;
  const fs::path part = file.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out << content << std::flush;
  if (!out) {
    const std::string why = std::strerror(errno);
    std::error_code ignored;
    fs::remove(part, ignored);
    throw UsageError(fmt::format("cannot write {} ({}); name a folder that can be written", file.string(), why));
  }
  move_file(part, file);
  return true;
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::rename(from, to, failed);
  if (failed)
    throw UsageError(
        fmt::format("cannot write {} ({}); name a folder that can be written", to.string(), failed.message()));
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder))
    throw UsageError(fmt::format("cannot make the folder {} ({}); name one that can be written", folder.string(),
                                 failed ? failed.message() : "a file is in its place"));
}

}  // namespace mpmvv
