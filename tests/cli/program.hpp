#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "tests/own_folder.hpp"

namespace mpmvv::cli {

/// The program that is tested: this build's, unless the environment names another's.
inline std::string program() {
  const char* other = std::getenv("MPMVV_PROGRAM");
  return other ? other : MPMVV_PROGRAM;
}

/// A folder of its own for one test, removed at the end.
class Folder {
 public:
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return *this / name;
  }

 private:
  std::filesystem::path path_ = own_folder("cli");
};

/// What a call of the program printed, and its exit code.
struct Answer {
  int code;
  std::string out, err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline std::string read_text(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What a shell says to the command.
inline Answer shell(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string out;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) out.append(buffer.data(), n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out, ""};
}

/// `before` is what the shell does first: "cd ... && ".
inline Answer call(const Folder& folder, const std::string& arguments, const std::string& before = "") {
  const std::string err = folder / "stderr";
  Answer answer = shell(before + "'" + program() + "' " + arguments + " 2>'" + err + "'");
  answer.err = read_text(err);
  return answer;
}

/// What a call in the folder prints on a terminal of so many columns, without colours.
inline std::string on_terminal(const Folder& folder, int columns, const std::string& arguments) {
  const std::string call = "stty cols " + std::to_string(columns) + "; '" + program() + "' " + arguments;
  const Answer shown = shell("cd '" + (folder / "") + "' && SHELL=/bin/sh script -qec \"" + call + "\" /dev/null");
  EXPECT_EQ(shown.code, 0) << arguments << shown.out;
  EXPECT_NE(shown.out, "") << arguments << " shows nothing, whose lines fit everywhere";
  return std::regex_replace(std::regex_replace(shown.out, std::regex("\033\\[[0-9;]*[a-zA-Z]"), ""),
                            std::regex("\r\n?"), "\n");
}

/// What a shell says in the folder to lines as a page has them: there the program is `mpmvv`.
inline Answer carry_out(const Folder& folder, const std::string& lines) {
  const std::string path = std::filesystem::path(program()).parent_path(), err = folder / "stderr";
  Answer answer = shell("cd '" + (folder / "") + "' && PATH='" + path + "':/usr/bin:/bin:\"$PATH\" && set -e && { " +
                        lines + "\n} 2>'" + err + "'");
  answer.err = read_text(err);
  return answer;
}

/// The digest of the program that is tested.
inline std::string own_digest(const Folder& folder) {
  const std::string version = call(folder, "--version").out;
  const std::size_t begin = version.find("\ndigest ") + 8;
  return version.substr(begin, version.find('\n', begin) - begin);
}

}  // namespace mpmvv::cli
