#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/own_folder.hpp"

namespace mpmvv::reports {

/// A folder of this test alone, gone at its end.
class TempFolder {
 public:
  TempFolder() = default;
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_ = own_folder("reports");
};

inline std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What two drawings of one picture have in common: cairo 1.18 compresses the date of a PDF, which stands at its end.
inline std::string content_without_date(const std::filesystem::path& file) {
  const std::string all = content(file);
  return all.starts_with("%PDF") ? all.substr(0, all.rfind("/Type /ObjStm")) : all;
}

/// PATH with another value until the end of the scope.
class PathVariable {
 public:
  explicit PathVariable(const std::string& value) : before_(std::getenv("PATH")) { setenv("PATH", value.c_str(), 1); }
  ~PathVariable() { setenv("PATH", before_.c_str(), 1); }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;

  const std::string& before() const { return before_; }

 private:
  std::string before_;
};

/// Makes a folder with a program `gnuplot` that is this shell script.
inline void pretend_gnuplot(const std::filesystem::path& folder, const std::string& script) {
  std::filesystem::create_directories(folder);
  const auto program = folder / "gnuplot";
  std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
}

}  // namespace mpmvv::reports
