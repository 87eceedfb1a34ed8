#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::goldens {

/// Runs that brought no result, in words: "the run at 8 is unstable, the runs at 16 and 32 failed; at 32: " and what
/// one of them says.
struct LostRuns {
  std::string text;   ///< empty where all are ok; ends with `cause`
  std::string cause;  ///< may be empty
};

/// Says which of a series' points are not ok. The cause is that of the run at `level` where it is one of them, else of
/// the last one.
LostRuns lost_runs(const std::vector<const records::Point*>& points, double level = support::not_measured);

}  // namespace mpmvv::goldens
