#include <algorithm>

#include "page_template.hpp"
#include "reports/gate_data.hpp"
#include "reports/page_frame.hpp"
#include "reports/verdicts.hpp"

namespace mpmvv::reports {

using namespace template_data;

namespace {

data titled_group(const ReportInput& input, const GateGroup& group) {
  data content = gate_group_data(group, input.studies);
  const auto study = std::ranges::find(input.studies, group.study, &records::StudyResult::name);
  if (study != input.studies.end()) content.set("study_title", study->title);
  return content;
}

}  // namespace

Page gate_page(const ReportInput& input) {
  const GateSplit split = gate_split(input);
  const auto group = [&](const GateGroup& of_study) { return titled_group(input, of_study); };
  return framed_page("gate.html", "Gate: " + gate_text(split), gate_template, input,
                     object({{"overall", gate_text(split)},
                             {"verdict", gate_word(split)},
                             {"gate_counts", gate_counts(split.judged)},
                             {"has_gate", !split.judged.empty()},
                             {"groups", list_of(gate_groups(split.judged), group)},
                             {"missing", missing_goldens_text(split.without_study)},
                             {"has_missing", !split.without_study.empty()}}));
}

}  // namespace mpmvv::reports
