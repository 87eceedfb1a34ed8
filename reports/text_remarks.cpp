#include "reports/text_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/text.hpp"
#include "reports/utf8.hpp"

namespace mpmvv::reports {

std::vector<std::string> drawn_texts(const Chart& chart) {
  std::vector<std::string> texts{chart.x.label, chart.y.label};
  if (chart.shades) texts.push_back(chart.shades->label);
  for (const Curve& curve : chart.curves)
    if (has_key(curve)) texts.push_back(curve.key);
  for (const Label& label : chart.labels) texts.push_back(label.text);
  if (chart.y.names)
    for (const Tic& tic : chart.y.tics) texts.push_back(tic.text);
  return texts;
}

std::vector<std::string> text_remarks(const std::vector<std::string>& texts, Format format) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) {
    if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(std::move(remark));
  };
  for (const std::string& text : texts) {
    if (text.find('$') != std::string::npos)
      add(fmt::format("'{}' is set with its $ signs (h^2, u_h and σ are set as mathematics without them)", text));
    if (format != Format::tex) continue;
    for (const std::string& character : without_latex(text))
      add(fmt::format("LaTeX cannot set '{}' in '{}' and gets [U+{:04X}] (another sign in the study file)", character,
                      text, code_point(character)));
  }
  return remarks;
}

}  // namespace mpmvv::reports
