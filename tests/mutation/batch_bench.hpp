#pragma once
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/mutation/bench.hpp"

namespace mpmvv::mutation {

/// Saves builds, which take far longer than most mutants live: builds many mutants at once, and lets one after the
/// other meet the unit tests and the quick gate. A mutant that cannot be built with others is built and tried alone; so
/// is, once more, one that is caught by nothing but goldens that cannot judge. The nightly gate is always met alone.
class BatchBench final : public Bench {
 public:
  static constexpr std::size_t least = 2, most = 100;  ///< mutants in one build

  /// coming: the edits that will be asked for, in their order. tell: progress, a line.
  BatchBench(Bench& alone, SchemataBench& together, std::vector<Edit> coming,
             std::function<void(const std::string&)> tell);

  bool build(const Edit* edit) override;
  Trial meet(GateStage stage, std::chrono::seconds limit) override;
  std::string complaint() const override { return alone_.complaint(); }

 private:
  void build_group(std::size_t first);
  /// Whether the group passes the stage with none of its mutants chosen.
  bool is_sound(GateStage stage, std::chrono::seconds limit);

  Bench& alone_;
  SchemataBench& together_;
  std::vector<Choice> coming_;
  std::function<void(const std::string&)> tell_;
  std::size_t next_ = 0;            ///< index of the first edit that no group has had yet
  std::set<int> group_;             ///< numbers of those that are built
  std::set<GateStage> sound_;       ///< stages that the group has passed with none chosen
  const Edit* edit_ = nullptr;      ///< that was asked for last
  const Choice* choice_ = nullptr;  ///< the same, where it is in the group
};

}  // namespace mpmvv::mutation
