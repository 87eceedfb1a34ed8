#include "cli/error_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "cli/console.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"
#include "studies/support/printable.hpp"

namespace mpmvv::cli {

using records::Point;
using records::Series;
using records::StudyResult;
using Kind = Table::Kind;

namespace {

std::string number_or_status(const Point& point, const std::string& quantity) {
  if (point.status != records::Status::ok) return to_string(point.status);
  const auto y = point.y.find(quantity);
  return y == point.y.end() ? "-" : error_text(y->second);
}

/// Quantities to print: those that are fitted or drawn, and cost where it was measured.
std::vector<std::string> quantities_of(const StudyResult& study) {
  std::vector<std::string> quantities;
  const auto add = [&quantities](const std::string& q) {
    if (std::ranges::find(quantities, q) == quantities.end()) quantities.push_back(q);
  };
  for (const records::Figure& figure : study.figures) add(figure.quantity);
  for (const Series& series : study.series)
    for (const fits::ObservedOrder& order : series.orders) add(order.norm);
  for (const Series& series : study.series)
    for (const Point& point : series.points)
      if (point.y.contains("step_seconds")) add("step_seconds");
  return quantities;
}

bool has_common_values(const StudyResult& study) {
  return std::ranges::all_of(study.series, [&](const Series& series) {
    return std::ranges::equal(series.points, study.series.front().points, {}, &Point::x, &Point::x);
  });
}

/// A series' name over its column, broken into short lines, at its commas first.
std::string head_of(const std::string& name) {
  constexpr std::size_t columns = 14;
  const std::string text = support::printable(name);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(", ", begin), text.size() - 1) + 1;
    for (std::string& line : wrapped(text.substr(begin, end - begin), columns)) lines.push_back(std::move(line));
    begin = text.find_first_not_of(' ', end);
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

Table table_of(const StudyResult& study, std::span<const Series> shown, const std::string& quantity) {
  std::vector<Table::Column> columns{{study.sweep, Kind::number}};
  for (const Series& series : shown) columns.push_back({head_of(series.name), Kind::number});
  Table table(columns);
  for (std::size_t k = 0; k < shown.front().points.size(); ++k) {
    std::vector<std::string> cells{fmt::format("{:.6g}", shown.front().points[k].x)};
    for (const Series& series : shown) cells.push_back(number_or_status(series.points[k], quantity));
    table.add(std::move(cells));
  }
  return table;
}

/// A column for each series, as many tables below each other as the terminal's width asks for.
void print_by_quantity(const StudyResult& study, const std::string& quantity) {
  print("\n  {} by {}\n", records::with_unit(quantity), study.sweep);
  const std::span<const Series> all(study.series);
  for (std::size_t begin = 0, count = 0; begin < all.size(); begin += count) {
    count = 1;
    const auto fits = [&](std::size_t n) {
      return begin + n <= all.size() && table_of(study, all.subspan(begin, n), quantity).width() <= text_width();
    };
    while (fits(count + 1)) ++count;
    if (begin > 0) print("\n");
    table_of(study, all.subspan(begin, count), quantity).print();
  }
}

void print_by_series(const StudyResult& study, const Series& series, const std::vector<std::string>& quantities) {
  print("\n  {}\n", series.name);
  std::vector<Table::Column> columns{{study.sweep, Kind::number}};
  for (const std::string& quantity : quantities) columns.push_back({records::with_unit(quantity), Kind::number});
  Table table(columns);
  for (const Point& point : series.points) {
    std::vector<std::string> cells{fmt::format("{:.6g}", point.x)};
    for (const std::string& quantity : quantities) cells.push_back(number_or_status(point, quantity));
    table.add(std::move(cells));
  }
  table.print();
}

}  // namespace

void print_errors(const StudyResult& study) {
  constexpr std::size_t longest_table = 40;
  const auto has_points = [](const Series& series) { return !series.points.empty(); };
  if (std::ranges::none_of(study.series, has_points)) return;
  const auto quantities = quantities_of(study);
  std::size_t longest = 0;
  for (const Series& series : study.series) longest = std::max(longest, series.points.size());
  if (longest > longest_table)
    return print("\n  {} of up to {} points: in the report\n", count_text(study.series.size(), "curve"), longest);
  if (has_common_values(study))
    for (const std::string& quantity : quantities) print_by_quantity(study, quantity);
  else
    for (const Series& series : study.series) print_by_series(study, series, quantities);
}

}  // namespace mpmvv::cli
