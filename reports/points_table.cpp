#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/segment_order.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

using records::Point;
using records::Series;
using records::StudyResult;
using support::not_measured;

namespace {

constexpr std::size_t longest_series = 40;
constexpr double round_off = 1e-12;  ///< a `..._change` up to this size is round-off

std::set<std::string> fitted_norms(const StudyResult& study) {
  std::set<std::string> norms;
  for (const auto& series : study.series)
    for (const auto& order : series.orders) norms.insert(order.norm);
  return norms;
}

std::string aligned(double v) {
  return std::isnan(v) ? "–" : fmt::format("{:.3e}", v);
}

double measured(const Point& point, const std::string& quantity) {
  const auto y = point.y.find(quantity);
  return y == point.y.end() ? not_measured : y->second;
}

/// Whether the quantity is a count, which is written out.
bool is_count(const std::string& quantity) {
  return quantity == "particles" || quantity == "steps" || quantity == "images";
}

std::string text_of(const std::string& quantity, double v) {
  return is_count(quantity) && !std::isnan(v) ? fmt::format("{:.0f}", v) : aligned(v);
}

/// "y: CFL limit": what a check's curves show, where all its figures say the same; else "y".
std::string head_of_curves(const StudyResult& study) {
  std::set<std::string> labels;
  for (const records::Figure& figure : study.figures)
    if (figure.quantity == "y") labels.insert(figure.ylabel);
  return labels.size() == 1 && !labels.begin()->empty() ? "y: " + *labels.begin() : "y";
}

/// The head of a column: the quantity with its unit, or what it is a share of; told from that of the swept values.
std::string head_of(const std::string& quantity, const StudyResult& study, int dimension) {
  if (quantity == "energy_loss") return "energy_loss (of the initial energy)";
  if (quantity == "y") return head_of_curves(study);
  const std::string head = records::with_unit(quantity, dimension);
  return head == study.sweep ? head + " of the run" : head;
}

/// A quantity in all rows of the table: the numbers that were measured.
struct Column {
  std::string quantity;
  std::vector<double> numbers;

  bool is_constant() const {
    const auto same = [&](double v) { return text_of(quantity, v) == text_of(quantity, numbers.front()); };
    return numbers.size() > 1 && std::ranges::all_of(numbers, same);
  }
  double largest() const {
    double most = 0;
    for (const double v : numbers) most = std::max(most, std::abs(v));
    return most;
  }
  bool is_round_off() const { return quantity.ends_with("_change") && numbers.size() > 1 && largest() <= round_off; }

  /// What its numbers have in common: "images = 1", "mass_change at most 3.0e-16"; empty where the rows have to say it.
  std::string in_common(int dimension) const {
    const std::string unit = records::unit_of(quantity, dimension);
    if (is_constant())
      return fmt::format("{} = {}{}", quantity,
                         is_count(quantity) ? text_of(quantity, numbers.front()) : brief(numbers.front()),
                         unit.empty() ? "" : " " + unit);
    return is_round_off() ? fmt::format("{} at most {:.1e}", quantity, largest()) : "";
  }
};

bool is_energy(const std::string& quantity) {
  return quantity == "kinetic" || quantity == "strain" || quantity == "initial_total";
}

constexpr int by_products = 300;  ///< the rank of the first

/// The order of the columns: what was fitted, what is drawn, what only checks measure, the other errors, the energy
/// loss, what else a run measures, and last its sizes.
int rank(const StudyResult& study, const std::set<std::string>& fitted, const std::string& quantity) {
  const auto index = [&](const std::vector<records::RunNumber>& numbers) {
    const auto found = std::ranges::find(numbers, quantity, &records::RunNumber::name);
    return found == numbers.end() ? -1 : static_cast<int>(found - numbers.begin());
  };
  if (fitted.contains(quantity)) return 0;
  if (std::ranges::find(study.figures, quantity, &records::Figure::quantity) != study.figures.end()) return 1;
  if (const int error = index(records::run_errors()); error >= 0) return 100 + error;
  if (const int other = index(records::run_by_products()); other >= 0) return by_products + other;
  if (quantity == "energy_loss") return 200;
  return is_count(quantity) || quantity == "dt" ? 400 : 2;
}

void add_to_note(std::string& note, const std::string& where, const std::vector<std::string>& what) {
  if (!what.empty()) note += fmt::format("{}{}: {}.", note.empty() ? "" : " ", where, fmt::join(what, ", "));
}

class PointsTable {
 public:
  PointsTable(const StudyResult& study, int dimension)
      : study_(study), dimension_(dimension), fitted_(fitted_norms(study)) {
    for (const Series& series : study.series)
      if (series.points.size() <= longest_series) series_.push_back(&series);
    read_columns();
  }

  Table make() const {
    Table table{points_caption, {study_.sweep}, {}};
    if (!all_ok_) table.columns.emplace_back("status");
    for (const Column& column : columns_) {
      table.columns.push_back(head_of(column.quantity, study_, dimension_));
      if (fitted_.contains(column.quantity)) table.columns.push_back("order of " + column.quantity);
    }
    if (has_reasons_) table.columns.emplace_back("reason");
    for (const Series* series : series_)
      if (!series->points.empty()) table.groups.push_back({series->name, rows_of(*series)});
    add_to_note(table.note, "At every point", same_);
    add_to_note(table.note, "At every point that has the number", same_where_measured_);
    add_to_note(table.note, "Measured, too, and in the CSV file", aside_);
    if (const std::size_t left_out = study_.series.size() - series_.size(); left_out > 0)
      add_to_note(table.note, "In the CSV file alone",
                  {fmt::format("{} series of more than {} points", left_out, longest_series)});
    return table;
  }

 private:
  void read_columns() {
    std::map<std::string, Column> columns;
    std::size_t points = 0;
    for (const Series* series : series_)
      for (const Point& point : series->points) {
        ++points;
        all_ok_ = all_ok_ && point.status == records::Status::ok;
        has_reasons_ = has_reasons_ || !point.reason.empty();
        for (const auto& [quantity, value] : point.y)
          if (!std::isnan(value)) columns[quantity].numbers.push_back(value);
      }
    all_ok_ = all_ok_ && points > 1;
    if (all_ok_) same_.emplace_back("status ok");
    for (auto& [quantity, column] : columns) column.quantity = quantity, columns_.push_back(std::move(column));
    std::ranges::stable_sort(columns_, {}, [&](const Column& c) { return rank(study_, fitted_, c.quantity); });
    std::erase_if(columns_, [&](const Column& column) {
      const std::string text = fitted_.contains(column.quantity) ? "" : column.in_common(dimension_);
      if (!text.empty()) (column.numbers.size() == points ? same_ : same_where_measured_).push_back(text);
      return !text.empty();
    });
    if (points < 2) return;
    const bool is_timed = std::ranges::find(columns_, "step_seconds", &Column::quantity) != columns_.end();
    std::erase_if(columns_, [&](const Column& column) {
      const bool is_aside = rank(study_, fitted_, column.quantity) >= by_products &&
                            (is_energy(column.quantity) || (!is_timed && column.quantity == "ns_per_particle_step"));
      if (is_aside) aside_.push_back(column.quantity);
      return is_aside;
    });
  }

  Table::Rows rows_of(const Series& series) const {
    Table::Rows rows;
    for (const Point& point : series.points) {
      std::vector<std::string>& row = rows.emplace_back();
      row = {brief(point.x)};
      if (!all_ok_) row.push_back(to_string(point.status));
      for (const Column& column : columns_) {
        row.push_back(text_of(column.quantity, measured(point, column.quantity)));
        if (fitted_.contains(column.quantity))
          row.push_back(order_text(segment_order(series, column.quantity, point.x), not_measured));
      }
      if (has_reasons_) row.push_back(point.reason);
    }
    return rows;
  }

  const StudyResult& study_;
  const int dimension_;
  const std::set<std::string> fitted_;
  std::vector<const Series*> series_;
  std::vector<Column> columns_;
  std::vector<std::string> same_, same_where_measured_, aside_;
  bool all_ok_ = true, has_reasons_ = false;
};

}  // namespace

Table points_table(const StudyResult& study, int dimension) {
  return PointsTable(study, dimension).make();
}

}  // namespace mpmvv::reports
