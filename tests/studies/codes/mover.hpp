#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "studies/codes/code.hpp"
#include "studies/settings/settings.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::codes {

/// A code in a folder of its own: a shell script that moves each particle by its velocity times the end time, which
/// solves problem `translation`. Runs have their folders in its own.
class Mover {
 public:
  Mover() {
    std::filesystem::create_directories(folder());
    setenv("TMPDIR", top_.c_str(), 1);
    write("input.mustache", "{{#particles}}\n{{id}} {{x}} {{y}} {{v_x}} {{v_y}} {{m}}\n{{/particles}}\n");
    script(moving);
    adapter(text);
  }
  ~Mover() {
    setenv("TMPDIR", top_.parent_path().c_str(), 1);
    std::filesystem::remove_all(top_);
  }
  Mover(const Mover&) = delete;
  Mover& operator=(const Mover&) = delete;

  static constexpr const char* moving = R"(
echo id,x,y,m > particles.csv
awk -v t="$1" '{ printf "%d,%.17g,%.17g,%.17g\n", $1, $2 + t * $4, $3 + t * $5, $6 }' input.txt >> particles.csv
)";
  static constexpr const char* text = R"(code = "mover"
[program]
variable = "MPMVV_TEST_MOVER"
command = "./mover"
[[input]]
template = "input.mustache"
file = "input.txt"
[command]
argv = ["{{program}}", "{{end_time}}"]
time_limit = 20
unstable = ["blown up"]
[output]
file = "particles.csv"
[variants.plain]
is_plain = true
is_odd = false
[capabilities]
dimensions = [2]
force_forms = ["reference", "none"]
boundaries = ["periodic"]
materials = ["neo-hookean-log"]
initial_velocity = true
)";

  static constexpr const char* study = R"(title = "Moved"
[fixed]
problem = "translation"
ppc = 2
cfl = 0.5
[[series]]
name = "theirs"
code = "mover"
[sweep]
cells = [4, 8, 16]
[[fit]]
norm = "l2"
window = [4, 16]
)";

  /// Lines of a script that start a process which goes on for a minute, and wait until it has written its number.
  static std::string start(const std::string& how, const std::string& file) {
    return how + " sh -c 'echo $$ > " + file + "; exec sleep 60' &\nuntil [ -s " + file + " ]; do sleep 0.01; done\n";
  }
  /// Whether the process of this number goes on; one that was killed has some seconds to be gone.
  static bool goes_on(const std::filesystem::path& file) {
    for (int k = 0; k < 500 && is_running(file); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return is_running(file);
  }

  std::filesystem::path top() const { return top_; }
  std::filesystem::path folder() const { return top_ / "adapters" / "mover"; }

  void write(const std::string& name, const std::string& content) const { std::ofstream(folder() / name) << content; }
  void script(const std::string& body) const {
    write("mover", "#!/bin/sh\n" + body);
    std::filesystem::permissions(folder() / "mover", std::filesystem::perms::owner_all);
  }
  void adapter(const std::string& content) const { write("adapter.toml", content); }

  Code code() const { return find_code(read_adapter(folder() / "adapter.toml")).value(); }

  static std::vector<settings::Setting> settings(const std::string& cells = "4") {
    return {{"problem", "translation", "test"},
            {"code", "mover", "test"},
            {"cells", cells, "test"},
            {"ppc", "2", "test"},
            {"cfl", "0.5", "test"}};
  }

 private:
  /// One that has ended may still be there, as nobody has asked for it.
  static bool is_running(const std::filesystem::path& file) {
    std::string number, word, state;
    std::ifstream(file) >> number;
    std::ifstream status("/proc/" + number + "/status");
    while (status >> word && word != "State:") continue;
    return status >> state && state != "Z";
  }

  std::filesystem::path top_ = own_folder("mover");
};

}  // namespace mpmvv::codes
