#include "tests/mutation/batch_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "studies/support/error.hpp"

namespace mpmvv::mutation {

using support::UsageError;

namespace {

/// Whether a mutant is caught by nothing but goldens that cannot judge.
bool is_doubtful(const Trial& trial) {
  return trial.caught && std::ranges::all_of(trial.by, is_inconclusive);
}

}  // namespace

BatchBench::BatchBench(Bench& alone, SchemataBench& together, std::vector<Edit> coming,
                       std::function<void(const std::string&)> tell)
    : alone_(alone), together_(together), tell_(std::move(tell)) {
  for (Edit& edit : coming) coming_.push_back({static_cast<int>(coming_.size()) + 1, std::move(edit)});
}

bool BatchBench::build(const Edit* edit) {
  edit_ = edit;
  choice_ = nullptr;
  if (edit == nullptr) return alone_.build(nullptr);
  const auto found = std::ranges::find(coming_, *edit, &Choice::edit);
  if (found == coming_.end()) return alone_.build(edit);
  const auto place = static_cast<std::size_t>(found - coming_.begin());
  if (place >= next_) build_group(place);
  if (group_.contains(found->number)) choice_ = &*found;
  return choice_ != nullptr || alone_.build(edit);
}

void BatchBench::build_group(std::size_t first) {
  next_ = std::min(first + most, coming_.size());
  group_.clear();
  if (next_ - first < least) return;
  const auto numbers = together_.build(
      {coming_.begin() + static_cast<std::ptrdiff_t>(first), coming_.begin() + static_cast<std::ptrdiff_t>(next_)});
  group_ = {numbers.begin(), numbers.end()};
  sound_.clear();
  tell_(fmt::format("{} of {} mutants built together", group_.size(), next_ - first));
  if (group_.empty()) tell_(together_.complaint());
}

bool BatchBench::is_sound(GateStage stage, std::chrono::seconds limit) {
  if (sound_.contains(stage)) return true;
  together_.choose(nullptr);
  Trial unedited = together_.meet(stage, limit);
  if (unedited.caught) unedited = together_.meet(stage, limit);  // on a busy machine a test may fail once
  if (!unedited.caught) return sound_.insert(stage).second;
  tell_(fmt::format("with none of them chosen {} complains of {}: each goes alone", to_string(stage),
                    unedited.by.front()));
  group_.clear();
  return false;
}

Trial BatchBench::meet(GateStage stage, std::chrono::seconds limit) {
  if (choice_ == nullptr) return alone_.meet(stage, limit);
  const bool in_group = group_.contains(choice_->number);
  if (stage != GateStage::nightly && in_group && is_sound(stage, limit)) {
    together_.choose(choice_);
    Trial trial = together_.meet(stage, limit);
    if (!is_doubtful(trial)) return trial;
  }
  if (!alone_.build(edit_))
    throw support::UsageError(
        fmt::format("an edit of {} compiles with others, but not alone: {}", edit_->file, alone_.complaint()));
  return alone_.meet(stage, limit);
}

}  // namespace mpmvv::mutation
