#include "cli/outputs.hpp"

#include <fmt/format.h>

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

void write_output(const std::string& option, const fs::path& file, const std::string& text) {
  constexpr std::size_t telling = 5;  // "<?xml", or a table's first columns
  std::string begin(telling, '\0');
  std::ifstream old(file, std::ios::binary);
  old.read(begin.data(), telling);
  begin.resize(static_cast<std::size_t>(old.gcount()));
  if (!begin.empty() && !text.starts_with(begin))
    throw support::UsageError(fmt::format(
        "{} {} is there, and is not what this command writes (another name, or remove it)", option, file.string()));
  support::write_if_changed(file, text);
}

}  // namespace mpmvv::cli
