#pragma once
#include "studies/cases/case.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

/// What a time is taken from.
enum class Source { same_case, like_cases, guess };

/// How long runs will take: what the same case took in the newest version that the store has it of, else what cases of
/// its problem and method (`cases::method_of`) took per particle and step, else a guess.
class CostModel {
 public:
  struct Time {
    double seconds;  ///< on one core
    Source source;
  };

  explicit CostModel(const store::Store* store);

  /// The time of all repetitions that the case asks for; of its part where only that is run.
  Time time(const cases::Case& c) const;

 private:
  const store::Store* store_;  ///< null: there is none yet
  store::StepCosts costs_;
};

}  // namespace mpmvv::plan
