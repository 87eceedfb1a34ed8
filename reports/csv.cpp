#include "reports/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "reports/segment_order.hpp"
#include "reports/text.hpp"
#include "studies/support/csv.hpp"

namespace mpmvv::reports {

using records::StudyResult;

namespace {

/// Lines of fields under a heading.
class Csv {
 public:
  explicit Csv(const std::vector<std::string>& columns) { add(columns); }

  void add(const std::vector<std::string>& fields) {
    text_ += support::csv_line(fields);
    ++lines_;
  }

  bool has_rows() const { return lines_ > 1; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int lines_ = 0;
};

Csv points_csv(const StudyResult& study) {
  std::set<std::string> quantities;
  for (const auto& series : study.series)
    for (const auto& point : series.points)
      for (const auto& [name, value] : point.y) quantities.insert(name);
  const auto is_fitted = [&](const std::string& quantity) {
    return std::ranges::any_of(study.series, [&](const records::Series& series) {
      return std::ranges::find(series.orders, quantity, &fits::ObservedOrder::norm) != series.orders.end();
    });
  };
  std::vector<std::string> head{"series", "x", "status"};
  for (const auto& q : quantities) {
    head.push_back(q);
    if (is_fitted(q)) head.push_back(q + "_order");
  }
  head.emplace_back("reason");
  Csv csv(head);
  for (const auto& series : study.series)
    for (const auto& point : series.points) {
      std::vector<std::string> row{series.name, exact(point.x), to_string(point.status)};
      for (const auto& q : quantities) {
        row.push_back(point.y.contains(q) ? exact(point.y.at(q)) : "");
        if (is_fitted(q)) row.push_back(exact(segment_order(series, q, point.x)));
      }
      row.push_back(point.reason);
      csv.add(row);
    }
  return csv;
}

std::vector<std::string> fit_row(const std::string& series, const fits::ObservedOrder& o) {
  const fits::FloorFit floor = o.floor.value_or(fits::FloorFit{});
  const fits::ReplicateFit replicates = o.replicates.value_or(fits::ReplicateFit{});
  const double half_width = fits::half_width(o);
  return {series,
          o.norm,
          exact(o.from),
          exact(o.to),
          fmt::format("{}", o.points),
          exact(o.order),
          exact(half_width > 0 ? half_width : fits::not_measured),
          exact(o.half_width),
          exact(o.constant),
          exact(o.r_squared),
          fmt::format("{}", o.asymptotic),
          exact(o.asymptotic_from),
          exact(o.asymptotic_to),
          o.floor ? fmt::format("{}", floor.accepted) : "",
          exact(floor.floor),
          exact(floor.order),
          exact(floor.constant),
          exact(floor.residual),
          floor.reason,
          o.replicates ? fmt::format("{}", replicates.observations) : "",
          exact(replicates.scatter),
          exact(replicates.half_width),
          exact(replicates.lack_of_fit)};
}

Csv fits_csv(const StudyResult& study) {
  Csv csv({"series",
           "norm",
           "from",
           "to",
           "points",
           "order",
           "half_width",
           "student_half_width",
           "constant",
           "r_squared",
           "asymptotic",
           "asymptotic_from",
           "asymptotic_to",
           "floor_accepted",
           "floor",
           "floor_order",
           "floor_constant",
           "floor_residual",
           "floor_reason",
           "replicate_observations",
           "replicate_scatter",
           "replicate_half_width",
           "lack_of_fit"});
  for (const auto& series : study.series)
    for (const auto& o : series.orders) csv.add(fit_row(series.name, o));
  return csv;
}

Csv replicates_csv(const StudyResult& study) {
  Csv csv({"series", "x", "quantity", "replicate", "value"});
  for (const auto& series : study.series)
    for (const auto& point : series.points)
      for (const auto& [quantity, values] : point.replicates)
        for (std::size_t k = 0; k < values.size(); ++k)
          csv.add({series.name, exact(point.x), quantity, fmt::format("{}", k + 1), exact(values[k])});
  return csv;
}

Csv extrapolations_csv(const StudyResult& study) {
  Csv csv({"series", "quantity", "from", "to", "points", "model", "order", "limit", "deviation", "finest",
           "uncertainty", "convergence_index", "remark"});
  for (const auto& series : study.series)
    for (const auto& e : series.extrapolations)
      csv.add({series.name, e.norm, exact(e.from), exact(e.to), fmt::format("{}", e.points), e.model, exact(e.order),
               exact(e.limit), exact(e.deviation), exact(e.finest), exact(e.uncertainty), exact(e.convergence_index),
               e.remark});
  return csv;
}

Csv limits_csv(const StudyResult& study) {
  Csv csv({"series", "key", "stable", "unstable", "found", "monotone"});
  for (const auto& series : study.series)
    if (series.limit)
      csv.add({series.name, series.limit->key, exact(series.limit->stable), exact(series.limit->unstable),
               fmt::format("{}", series.limit->found), fmt::format("{}", series.limit->monotone)});
  return csv;
}

Csv probes_csv(const StudyResult& study) {
  Csv csv({"series", "key", "value", "stable", "steps", "reason"});
  for (const auto& series : study.series) {
    if (!series.limit) continue;
    for (const auto& p : series.limit->probes)
      csv.add({series.name, series.limit->key, exact(p.value), fmt::format("{}", p.stable),
               p.steps > 0 ? fmt::format("{}", p.steps) : "", p.reason});
  }
  return csv;
}

Csv values_csv(const StudyResult& study) {
  Csv csv({"name", "value", "meaning"});
  for (const auto& v : study.values) csv.add({v.name, exact(v.value), v.meaning});
  return csv;
}

}  // namespace

std::map<std::string, std::string> csv_tables(const StudyResult& study) {
  std::map<std::string, std::string> files{{study.name + ".csv", points_csv(study).text()}};
  const auto add = [&](const std::string& what, const Csv& csv) {
    if (csv.has_rows()) files[what + "/" + study.name + ".csv"] = csv.text();
  };
  add("fits", fits_csv(study));
  add("replicates", replicates_csv(study));
  add("extrapolations", extrapolations_csv(study));
  add("limits", limits_csv(study));
  add("probes", probes_csv(study));
  add("values", values_csv(study));
  return files;
}

}  // namespace mpmvv::reports
