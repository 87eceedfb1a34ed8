#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "page_template.hpp"
#include "reports/criteria.hpp"
#include "reports/mutation_claim.hpp"
#include "reports/page_frame.hpp"

namespace mpmvv::reports {

using namespace template_data;

namespace {

bool is_study_of(const Section& section, const claims::Claim& claim) {
  const auto& named = section.study->claims;
  return std::ranges::find(named, claim.id) != named.end() ||
         std::ranges::find(claim.parts, section.study->name, &claims::JudgedPart::study) != claim.parts.end();
}

}  // namespace

Page claim_page(const ReportInput& input, const claims::Claim& claim, const std::vector<Section>& sections) {
  data studies{data::type::list}, pictures{data::type::list};
  std::vector<std::string> names;
  for (const Section& section : sections) {
    if (!is_study_of(section, claim)) continue;
    studies << object({{"study", section.study->name}, {"title", section.study->title}});
    for (const Picture& picture : section.pictures) pictures << picture_data(picture);
    names.push_back(section.study->name);
  }
  return framed_page("claims/" + anchor(claim.id) + ".html", claim.id + ": " + to_string(claim.verdict), claim_template,
                     input,
                     object({{"id", claim.id},
                             {"statement", claim.statement},
                             {"source", claim.source},
                             {"where", claim.where},
                             {"has_source", !claim.source.empty()},
                             {"has_where", !claim.where.empty()},
                             {"verdict", to_string(claim.verdict)},
                             {"deciding", deciding_text(claim)},
                             {"has_deciding", !deciding_text(claim).empty()},
                             {"count", count_text(claim)},
                             {"has_parts", !claim.parts.empty()},
                             {"parts", criteria_data(claim.parts)},
                             {"pictures", pictures},
                             {"studies", studies},
                             {"not_run", fmt::format("{}", fmt::join(claim.not_run, ", "))},
                             {"has_not_run", !claim.not_run.empty()},
                             {"command", claim.id == mutants_claim ? mutants_command : command_of(input, names)}}));
}

}  // namespace mpmvv::reports
