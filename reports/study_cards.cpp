#include "reports/study_cards.hpp"

#include <fmt/format.h>

#include "reports/text.hpp"

namespace mpmvv::reports {

using namespace template_data;

namespace {

/// "order 1.97 ± 0.28 of bspline2 in l2", "limit cfl 0.82 to 0.86 of gimp": a line for each of the first.
std::vector<std::string> fitted_lines(const records::StudyResult& study) {
  constexpr std::size_t most = 4;
  std::vector<std::string> lines;
  for (const auto& series : study.series) {
    for (const auto& o : series.orders)
      lines.push_back(fmt::format("order {} of {} in {}", order_text(o), series.name, o.norm));
    if (series.limit && series.limit->found)
      lines.push_back(fmt::format("limit {} {} to {} of {}", series.limit->key, brief(series.limit->stable),
                                  brief(series.limit->unstable), series.name));
  }
  for (const auto& value : study.values) lines.push_back(fmt::format("{} = {}", value.name, brief(value.value)));
  if (lines.size() > most) lines.resize(most);
  return lines;
}

data study_card(const Section& section) {
  const auto& pictures = section.pictures;
  return object({{"study", section.study->name},
                 {"title", section.study->title},
                 {"lines", text_list(fitted_lines(*section.study))},
                 {"pictures", list_of(pictures.empty() ? pictures : std::vector{pictures.front()}, picture_data)}});
}

}  // namespace

data study_cards(const std::vector<Section>& sections) {
  data cards{data::type::list};
  for (const Section& section : sections)
    if (section.study->claims.empty()) cards << study_card(section);
  return cards;
}

}  // namespace mpmvv::reports
