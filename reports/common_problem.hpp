#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// The problem that all of these series of a study are runs of, by the study's text and its trial; empty where they
/// differ, or where the text does not tell.
std::string common_problem(const records::StudyResult& study, const std::vector<const records::Series*>& series);

}  // namespace mpmvv::reports
