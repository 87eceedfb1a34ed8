#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "studies/store/provenance.hpp"
#include "tests/mutation/mutant.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::mutation::samples {

inline Mutant mutant(const std::string& name, std::vector<Trial> trials, const std::string& gate = "g1") {
  return {.name = name,
          .kind = Mutant::Kind::planted,
          .what = "a \"sign\", or two",
          .file = "solver/grid.hpp",
          .line = 12,
          .before = "a + b;\n  c",
          .after = "a - b;\n  c",
          .gate = gate,
          .builds = true,
          .trials = std::move(trials)};
}

inline const Trial passes{GateStage::unit_tests, false, {}, 1.5}, quick{GateStage::quick}, nightly{GateStage::nightly};
inline const Trial caught{GateStage::quick, true, {"s-fig10: order of 'linear' in l2", "w-one: value 'x'"}, 60};

/// Of every kind and every fate.
inline std::vector<Mutant> sample() {
  std::vector<Mutant> all{mutant("baseline", {passes}),
                          mutant("seen", {passes, caught}),
                          mutant("by tests", {{GateStage::unit_tests, true, {"A.B"}, 1}}),
                          mutant("missed", {passes, quick, nightly}),
                          mutant("open", {passes, quick}),
                          mutant("silent", {passes})};
  all[0].kind = Mutant::Kind::baseline;
  all[5].reason = "efficiency only";
  for (const char* name : {"caught", "equal", "hole", "broken"}) {
    all.push_back(mutant(name, {passes, quick, nightly}));
    all.back().kind = Mutant::Kind::random;
  }
  all[6].trials[1] = caught;
  all[7].reason = "equivalent";
  all[9].builds = false;
  return all;
}

inline store::Provenance provenance(const std::string& digest = "d1") {
  return {.digest = digest,
          .commit = "c0ffee",
          .dirty = false,
          .compiler = "",
          .flags = "",
          .build_type = "",
          .cpu = "",
          .time = ""};
}

/// The files of the program's own sources, and the text of one.
inline std::vector<std::string> sources() {
  const std::filesystem::path top = MPMVV_SOURCE_DIR;
  std::vector<std::string> files;
  for (const char* folder : {"mms", "solver", "studies", "goldens", "reports", "cli"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / folder))
      if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(top).generic_string());
  return files;
}
inline std::string source(const std::string& file) {
  return (std::stringstream() << std::ifstream(std::string(MPMVV_SOURCE_DIR) + "/" + file).rdbuf()).str();
}

/// A folder of its own for every test, gone at its end.
class OwnFolder {
 public:
  ~OwnFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_ = own_folder("mutation");
};

}  // namespace mpmvv::mutation::samples
