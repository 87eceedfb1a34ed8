#include "reports/page_frame.hpp"

#include "page_template.hpp"
#include "reports/text.hpp"
#include "reports/verdicts.hpp"

namespace mpmvv::reports {

using namespace template_data;

Page framed_page(const std::string& file, const std::string& title, std::string_view text, const ReportInput& input,
                 data content) {
  content.set("page_title", title);
  content.set("root", file.find('/') == std::string::npos ? "" : "../");
  content.set("head", partial(head_template));
  content.set("foot", partial(foot_template));
  content.set("picture_list", partial(pictures_template));
  content.set("table_list", partial(tables_template));
  content.set("criterion_table", partial(criteria_template));
  content.set("gate_table", partial(gate_table_template));
  content.set("has_any_claim", !input.claims.empty());
  content.set("has_trends", !input.histories.empty());
  content.set("has_codes", !input.codes.empty());
  content.set("has_mutants", input.mutation.has_value());
  content.set("has_benchmark", input.benchmark.has_value());
  content.set("version", versions_text(origins_of(input.provenances)));
  kainjow::mustache::mustache page{std::string(text)};
  return {file, marked_up_text(page.render(content))};
}

std::string command_of(const ReportInput& input, const std::vector<std::string>& studies) {
  std::vector<StudyCall> calls;
  for (const std::string& study : studies) {
    const auto known = input.calls.find(study);
    calls.push_back(known == input.calls.end() ? StudyCall{study + ".toml"} : known->second);
  }
  return study_command(calls, "results.db", "trial.db");
}

std::vector<Page> points_pages(const Section& section) {
  std::vector<Page> pages;
  for (const Picture& picture : section.pictures)
    if (!picture.points.empty())
      pages.push_back({fmt::format("points/{}.js", picture.name),
                       fmt::format("tellPoints(\"figure-{}\", {});\n", anchor(picture.name), picture.points)});
  return pages;
}

std::vector<Page> page_aids() {
  return {{"style.css", std::string(pages_style)}, {"report.js", std::string(pages_script)}};
}

}  // namespace mpmvv::reports
