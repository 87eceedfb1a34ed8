#pragma once
#include <optional>
#include <vector>

#include "goldens/comparison.hpp"
#include "goldens/golden.hpp"
#include "reports/report.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::cli {

reports::Changes changes_of(const goldens::Comparison& comparison);

/// What the version before the running program's says, compared with the results of `now`; none where the store has no
/// earlier version.
std::optional<reports::Earlier> earlier_version(const store::Store& store, const std::vector<goldens::Golden>& goldens,
                                                const std::vector<records::StudyResult>& now);

}  // namespace mpmvv::cli
