#pragma once
#include <map>
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// The number of the style of each series of a study, by name. A series has one in all figures of its study: the
/// smallest that no series before it has with which it shares a figure. So the series of a figure of all are numbered
/// in the order of the study, and figures without a common series begin anew. Where a paper names series (papers.toml),
/// these have the same one in all of its studies.
std::map<std::string, int> series_styles(const records::StudyResult& study);

}  // namespace mpmvv::reports
