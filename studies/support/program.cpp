#include "studies/support/program.hpp"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace mpmvv::support {

namespace fs = std::filesystem;

bool is_program(const fs::path& file) {
  std::error_code unknown;
  return fs::is_regular_file(file, unknown) && access(file.c_str(), X_OK) == 0;
}

fs::path program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name; is_program(file)) return fs::absolute(file);
  return {};
}

}  // namespace mpmvv::support
