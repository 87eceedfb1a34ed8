#include "cli/shipped.hpp"

#include <system_error>

namespace mpmvv::cli {

namespace fs = std::filesystem;

fs::path shipped(const std::string& folder) {
  std::error_code unknown;
  const fs::path place = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const fs::path& top : {place.parent_path() / "share" / "mpmvv", place.parent_path().parent_path()})
    if (fs::exists(top / "studies" / "quick.txt", unknown)) return top / folder;
  return {};
}

}  // namespace mpmvv::cli
