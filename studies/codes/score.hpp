#pragma once
#include <optional>
#include <string>

#include "studies/codes/adapter.hpp"
#include "studies/codes/snapshot.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// The particles that a code wrote of a run.
struct Output {
  std::optional<Snapshot> start = {};  ///< those at time zero, if the end alone does not say which particle is which
  Snapshot end;                        ///< those at the case's end time
  std::optional<double> time = {};     ///< the time in s at which the end is scored, if it is not the case's end time
};

/// Measures another code's output and returns the record of the case, as `runs::run_case` makes it, with the numbers
/// that the output allows. An output with a fault gives a record with status `unstable` or `failed` and the reason. So
/// does one without stresses if a case of a code asks for their error. The caller fills in the costs. Throws UsageError
/// if the problem has no exact solution.
records::Record score(const cases::Case& c, const Output& output);

/// As above, of a code that steps as its adapter says. A time that is not the end time, though within `time_tolerance`
/// of it, is the one at which the output is measured. Of a code that chooses its steps the record has their number as
/// the output states it, else 0, and no Courant number; what the output says of them is not compared with the case.
records::Record score(const cases::Case& c, const Stepping& stepping, Output output);

/// Returns a warning if the exact solution of the case ends where it starts, so that a score says little; else empty.
std::string caution(const cases::Case& c);

}  // namespace mpmvv::codes
