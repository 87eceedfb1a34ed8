#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/mutation/bench.hpp"
#include "tests/mutation/scratch_tree.hpp"

namespace mpmvv::mutation {

/// The program's own gate in a scratch tree: CMake with the preset `mutants`, the test programs, the studies as
/// `./run quick` and `./run nightly` run them.
class ProgramBench final : public SchemataBench {
 public:
  /// jobs: compilers and cases at once.
  ProgramBench(ScratchTree& scratch, int jobs);

  bool build(const Edit* edit) override;
  std::vector<int> build(const std::vector<Choice>& choices) override;
  void choose(const Choice* choice) override;
  Trial meet(GateStage stage, std::chrono::seconds limit) override;
  std::string complaint() const override { return complaint_; }

 private:
  void configure() const;
  void reach_for(const Edit* edit);  ///< sets what the edit, or the tree without one, has to meet
  support::ProcessEnd make(const std::vector<std::string>& targets) const;
  bool compiles(const std::string& target);
  support::ProcessEnd run(const std::vector<std::string>& command, std::chrono::seconds limit,
                          std::map<std::string, std::string> environment = {}, const std::stop_token& stop = {}) const;
  /// Several times what a study or test program took without a mistake; where that is not known, its stage's limit.
  std::chrono::seconds limit_of(const std::string& name, std::chrono::seconds stage_limit) const;
  void learn(const std::string& name, const support::ProcessEnd& end, double took);  ///< remembers what is usual
  support::ProcessEnd run_confined(const std::vector<std::string>& command, std::chrono::seconds limit,
                                   std::map<std::string, std::string> environment = {},
                                   const std::stop_token& stop = {}) const;
  /// A test program in parts, as many as there are jobs; the end of the first that does not pass.
  support::ProcessEnd run_test(const std::string& test, std::chrono::seconds limit);
  Trial run_unit_tests(std::chrono::seconds stage_limit);
  Trial run_gate(GateStage stage, const std::vector<std::string>& studies, std::chrono::seconds stage_limit);
  /// What does not pass of one study, run and judged; empty when all of it passes.
  std::vector<std::string> complaints_of(const std::string& study, const std::string& db,
                                         std::chrono::seconds stage_limit);
  std::string program(const std::string& name) const { return (scratch_.build() / name).string(); }

  ScratchTree& scratch_;
  int jobs_;
  std::vector<std::string> quick_, nightly_;  ///< names of studies
  std::vector<std::string> tests_;            ///< test programs that the edit can reach
  int chosen_ = 0;                            ///< number of a choice, 0 for none
  bool is_edited_ = false;                    ///< whether what was built or chosen last has a mistake
  bool decides_the_gate_ = true;              ///< whether that may change what the gate says
  std::map<std::string, double> usual_;       ///< seconds of studies and test programs without a mistake
  std::string complaint_;
};

}  // namespace mpmvv::mutation
