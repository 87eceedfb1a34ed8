#pragma once
#include <optional>
#include <string>

#include "studies/codes/snapshot.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// What a code wrote of a run.
struct Output {
  std::optional<Snapshot> start = {};  ///< at time zero, where the end alone does not say which particle is which
  Snapshot end;                        ///< at the case's end time
};

/// The record of a case from another code's output: as `runs::run_case` makes it, as far as the output goes. Whatever
/// is wrong with the output is a record too, with status `unstable` or `failed` and the reason. Its costs are the
/// caller's to fill in.
records::Record score(const cases::Case& c, const Output& output);

/// What to know of any score of the case: that its exact end is its start. Empty where there is nothing to.
std::string caution(const cases::Case& c);

}  // namespace mpmvv::codes
