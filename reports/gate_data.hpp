#pragma once
#include <string>
#include <vector>

#include "reports/template_data.hpp"
#include "reports/verdicts.hpp"

namespace mpmvv::reports {

/// A study's goldens for their template; those of a check's values with what the study says they mean.
template_data::data gate_group_data(const GateGroup& group, const std::vector<records::StudyResult>& studies);

/// The goldens that do not pass, by study.
template_data::data failing_goldens(const std::vector<GateLine>& judged,
                                    const std::vector<records::StudyResult>& studies);

/// "14 goldens are of 2 studies that this report has no result of: a, b."; empty where there is none.
std::string missing_goldens_text(const std::vector<GateLine>& lines);

}  // namespace mpmvv::reports
