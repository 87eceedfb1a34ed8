#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "studies/codes/code.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::codes {

/// A code in a folder of its own: a shell script that moves each particle by its velocity times the end time, which
/// solves problem `translation`.
class Mover {
 public:
  Mover() : top_(std::filesystem::temp_directory_path() / ("mpmvv-mover-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder());
    write("input.mustache", "{{#particles}}\n{{id}} {{x}} {{y}} {{v_x}} {{v_y}} {{m}}\n{{/particles}}\n");
    script(moving);
    adapter(text);
  }
  ~Mover() { std::filesystem::remove_all(top_); }
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
  std::filesystem::path top_;
};

}  // namespace mpmvv::codes
