#include <set>

#include "page_template.hpp"
#include "reports/code_table.hpp"
#include "reports/mutant_table.hpp"
#include "reports/page_frame.hpp"
#include "reports/table_data.hpp"

namespace mpmvv::reports {

using namespace template_data;

namespace {

std::vector<std::string> studies_of_codes(const ReportInput& input) {
  std::set<std::string> studies;
  for (const store::CodeSeries& series : input.codes) studies.insert(series.study);
  return {studies.begin(), studies.end()};
}

}  // namespace

std::vector<Page> program_pages(const ReportInput& input) {
  std::vector<Page> pages;
  if (input.benchmark)
    pages.push_back(framed_page("benchmark.html", "Benchmark", benchmark_template, input,
                                object({{"tables", list_of(benchmark_tables(*input.benchmark), table_data)}})));
  if (!input.codes.empty())
    pages.push_back(framed_page("codes.html", "Other codes", codes_template, input,
                                object({{"tables", list_of(std::vector{code_table(input)}, table_data)},
                                        {"studies", text_list(studies_of_codes(input))}})));
  if (input.mutation)
    pages.push_back(framed_page("mutants.html", "Planted mistakes", mutants_template, input,
                                object({{"tables", list_of(mutant_tables(*input.mutation, input.alarms), table_data)},
                                        {"is_summary", input.mutation->mistakes.empty()},
                                        {"is_of_another_build", input.mutation->digest != input.digest},
                                        {"commit", store::in_short(input.mutation->commit)}})));
  return pages;
}

}  // namespace mpmvv::reports
