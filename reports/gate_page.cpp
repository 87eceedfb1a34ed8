#include "page_template.hpp"
#include "reports/gate_data.hpp"
#include "reports/page_frame.hpp"
#include "reports/verdicts.hpp"

namespace mpmvv::reports {

using namespace template_data;

Page gate_page(const ReportInput& input) {
  const GateSplit split = gate_split(input);
  return framed_page("gate.html", "Gate: " + gate_verdict(split.judged), gate_template, input,
                     object({{"overall", gate_verdict(split.judged)},
                             {"gate_counts", gate_counts(split.judged)},
                             {"has_gate", !split.judged.empty()},
                             {"groups", list_of(gate_groups(split.judged), gate_group_data)},
                             {"missing", missing_goldens_text(split.without_study)},
                             {"has_missing", !split.without_study.empty()}}));
}

}  // namespace mpmvv::reports
