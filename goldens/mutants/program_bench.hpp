#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "goldens/mutants/bench.hpp"
#include "goldens/mutants/laboratory.hpp"

namespace mpmvv {

/// The program's own gate in a laboratory: CMake with the preset `mutants`, the test programs, the studies as
/// `./run quick` and `./run nightly` run them.
class ProgramBench final : public ChoiceBench {
 public:
  /// jobs: compilers and cases at once.
  ProgramBench(Laboratory& laboratory, int jobs);

  bool build(const Edit* edit) override;
  std::vector<int> build(const std::vector<Choice>& choices) override;
  void choose(const Choice* choice) override;
  Trial meet(GateStage stage, std::chrono::seconds limit) override;
  std::string complaint() const override { return complaint_; }

 private:
  void configure() const;
  support::ProcessEnd make(const std::vector<std::string>& targets) const;
  bool compiles(const std::string& target);
  support::ProcessEnd run(const std::vector<std::string>& command, std::chrono::seconds limit) const;
  /// Several times what a study or test program took without a mistake; where that is not known, its stage's limit.
  std::chrono::seconds limit_of(const std::string& name, std::chrono::seconds stage_limit) const;
  support::ProcessEnd run_confined(const std::string& name, const std::vector<std::string>& command,
                                   std::chrono::seconds limit);
  Trial run_unit_tests(std::chrono::seconds stage_limit);
  Trial run_gate(GateStage stage, const std::vector<std::string>& studies, std::chrono::seconds stage_limit);
  /// What does not pass of one study, run and judged; empty when all of it passes.
  std::vector<std::string> complaints_of(const std::string& study, const std::string& db,
                                         std::chrono::seconds stage_limit);
  std::string program(const std::string& name) const { return (laboratory_.build() / name).string(); }

  Laboratory& laboratory_;
  int jobs_;
  std::vector<std::string> quick_, nightly_;  ///< names of studies
  std::vector<std::string> tests_;            ///< test programs that the edit can reach
  int chosen_ = 0;                            ///< number of a choice, 0 for none
  bool is_edited_ = false;                    ///< whether what was built or chosen last has a mistake
  std::map<std::string, double> usual_;       ///< seconds of studies and test programs without a mistake
  std::string complaint_;
};

/// The parts of the tree that a laboratory of the program needs.
std::vector<std::string> program_parts();

/// A digest of what decides how a mutant fares: of the sources, a slash, and of the tests, goldens, studies and
/// reports: with other reports only what passed is tried again.
std::string gate_version(const Laboratory& laboratory);

/// The names of the studies in a list such as studies/quick.txt.
std::vector<std::string> listed_studies(const std::string& text);

/// The test programs that a change of this file reaches, what is least to build first; all for an empty name.
std::vector<std::string> test_programs(const std::string& file);

/// The numbers of the choices, given by their files, of which a compiler's output names lines with the edit; where
/// there is none, of those of which it names any line.
std::set<int> choices_named(const std::string& output, const std::map<std::string, std::vector<ChoicePlace>>& places);

/// The first test that failed by what a test program printed; with none, the one in which it ended.
std::string failed_test(const std::string& output);

/// "study: golden" of what does not pass, from `mpmvv gate --json`; what is inconclusive is marked, and comes last.
std::vector<std::string> goldens_not_passed(const std::string& json);

/// Study by study up to the first of which anything fails: most mistakes need no more than the first few. What is
/// inconclusive alone counts where nothing fails.
Trial first_catch(GateStage stage, const std::vector<std::string>& studies,
                  const std::function<std::vector<std::string>(const std::string& study)>& complaints_of);

}  // namespace mpmvv
