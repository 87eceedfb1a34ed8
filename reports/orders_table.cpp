#include "reports/orders_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/chart.hpp"
#include "reports/text.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::reports {

namespace {

Table::Rows orders_of(const records::StudyResult& study) {
  Table::Rows rows;
  for (const auto& series : study.series)
    for (const auto& o : series.orders)
      rows.push_back({series.name, o.norm, window_text(o.from, o.to), claims::points_text(series, o), order_text(o),
                      o.floor && o.floor->accepted ? brief(o.floor->floor) : "–", fits::asymptotic_word(o)});
  return rows;
}

std::string three_digit_number(double v) {
  return std::isnan(v) ? "–" : fmt::format("{:.3g}", v);
}

Table::Rows extrapolated(const records::StudyResult& study) {
  Table::Rows rows;
  for (const auto& series : study.series)
    for (const auto& e : series.extrapolations)
      rows.push_back({series.name, e.norm, window_text(e.from, e.to), claims::extrapolated_to(study.sweep),
                      three_digit_number(e.limit), three_digit_number(e.finest), three_digit_number(e.uncertainty)});
  return rows;
}

/// "s-fig10 (cells): Orders of the bases. Made with --set: ppc = 2 in 2 of 2 series."
std::string title_of(const records::StudyResult& study) {
  const std::string trial = trial_sentence(study);
  return fmt::format("{} ({}): {}{}", study.name, study.sweep, study.title, trial.empty() ? "" : ". " + trial);
}

}  // namespace

Table orders_table(const std::vector<const records::StudyResult*>& studies) {
  Table table{"Fitted orders ± half of their intervals; the window is in the swept key",
              {"series", "norm", "window", "points", "order", "floor", "asymptotic"},
              {}};
  for (const auto* study : studies)
    if (auto rows = orders_of(*study); !rows.empty()) table.groups.push_back({title_of(*study), std::move(rows)});
  return table;
}

Table extrapolated_table(const std::vector<const records::StudyResult*>& studies) {
  Table table{"Extrapolated values, and the finest ones of the windows with their uncertainty U (Eça and Hoekstra)",
              {"series", "norm", "window", "to", "value", "finest", "U"},
              {}};
  for (const auto* study : studies)
    if (auto rows = extrapolated(*study); !rows.empty()) table.groups.push_back({title_of(*study), std::move(rows)});
  return table;
}

}  // namespace mpmvv::reports
