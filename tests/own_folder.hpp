#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

namespace mpmvv {

/// A new folder among the temporary files, for a test that removes it at its end. What another process of this number
/// has left there, because it was killed, goes first.
inline std::filesystem::path own_folder(const std::string& name) {
  auto folder = std::filesystem::temp_directory_path() / ("mpmvv-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace mpmvv
