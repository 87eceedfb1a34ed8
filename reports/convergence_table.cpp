#include "reports/convergence_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "reports/chart.hpp"
#include "reports/latex_table.hpp"
#include "reports/norm_symbol.hpp"
#include "reports/segment_order.hpp"
#include "reports/template_data.hpp"
#include "reports/text.hpp"
#include "reports/typeset.hpp"
#include "studies/claims/samples.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

using fits::ObservedOrder;
using records::Point;
using records::Series;
using records::StudyResult;

namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::size_t abreast = 4, abreast_without_orders = 5;
constexpr std::size_t lines_on_page = 50;
constexpr const char* none = "--";

/// The problems that the study's file names, in its order; none where it cannot be read.
std::vector<std::string> problems_of(const StudyResult& study) {
  std::vector<std::string> problems;
  const auto add = [&](const support::TomlTable& table) {
    const std::string problem = table.text("problem", "");
    if (!problem.empty() && std::ranges::find(problems, problem) == problems.end()) problems.push_back(problem);
  };
  try {
    const auto file = support::TomlTable::parse(study.text, study.name);
    if (const auto fixed = file.table("fixed")) add(*fixed);
    for (const auto& series : file.tables("series")) add(series);
  } catch (const support::UsageError&) {
    return {};
  }
  return problems;
}

std::string in_three_digits(double error) {
  return error == 0 ? "0" : fmt::format("{:.2e}", error);
}

/// The swept key as the head of a column.
std::string head_of_sweep(const std::string& sweep) {
  if (sweep == "dt") return "$\\Delta t$ (s)";
  return sweep == "cfl" ? "CFL" : typeset(sweep, Notation::latex);
}

/// Of what orders are powers.
std::string base_of_orders(const std::string& sweep) {
  if (sweep == "cells") return "the cell width $h$";
  if (sweep == "cfl") return "the Courant number";
  return sweep == "dt" ? "$\\Delta t$" : sweep == "ppc" ? "1/ppc" : latex_text(sweep);
}

std::string name_of(const std::pair<double, double>& window) {
  return fmt::format("{} to {}", brief(window.first), brief(window.second));
}

bool takes_all(const Series& series, const ObservedOrder& order) {
  return claims::points_text(series, order) == fmt::format("{}", order.points);
}

/// The table of one norm.
class ConvergenceTable {
 public:
  ConvergenceTable(const StudyResult& study, const std::string& norm) : study_(study), norm_(norm) {
    for (const Series& series : study.series) {
      const bool has_any = std::ranges::any_of(series.points, [&](const Point& point) { return is_measured(point); });
      if (series.points.size() > longest_shown || !has_any) continue;
      series_.push_back(&series);
      for (const Point& point : series.points) levels_.insert(point.x);
      for (const ObservedOrder& order : orders_of(series)) {
        windows_.insert({order.from, order.to});
        if (!takes_all(series, order))
          fewer_.push_back(fmt::format("{} ({})", series.name, claims::points_text(series, order)));
      }
    }
  }

  std::string text() const {
    if (series_.empty()) return "";
    const std::size_t most = most_abreast();
    const std::size_t parts = (series_.size() + most - 1) / most, each = (series_.size() + parts - 1) / parts;
    const std::size_t on_page = std::max<std::size_t>(1, lines_on_page / (levels_.size() + windows_.size() + 4));
    std::string text;
    for (std::size_t part = 0; part < parts; ++part) {
      if (part % on_page == 0) text += (part > 0 ? "\\end{table}\n" : "") + beginning(part == 0);
      const auto shown = std::span(series_).subspan(part * each);
      text += tabular(shown.first(std::min(each, shown.size()))) + "\\par\\medskip\n";
    }
    return text + "\\end{table}\n";
  }

 private:
  bool is_measured(const Point& point) const {
    const auto y = point.y.find(norm_);
    return y != point.y.end() && !std::isnan(y->second);
  }

  std::vector<ObservedOrder> orders_of(const Series& series) const {
    std::vector<ObservedOrder> own;
    std::ranges::copy_if(series.orders, std::back_inserter(own),
                         [&](const ObservedOrder& order) { return order.norm == norm_; });
    return own;
  }

  bool has_orders() const { return !windows_.empty(); }

  /// How many series stand abreast: fewer where the windows have long names.
  std::size_t most_abreast() const {
    constexpr std::size_t short_name = 11;
    const bool is_long = std::ranges::any_of(windows_, [&](const auto& w) { return name_of(w).size() > short_name; });
    return !has_orders() ? abreast_without_orders : is_long ? abreast - 1 : abreast;
  }

  std::string beginning(bool is_first) const {
    const std::string label = fmt::format("tab:{}-{}", template_data::anchor(study_.name), norm_);
    return fmt::format(
        "\n\\begin{{table}}[htbp]\n\\centering\\footnotesize\\setlength{{\\tabcolsep}}{{2pt}}\n{}\\par\\medskip\n",
        is_first ? fmt::format("\\caption{{{}}}\n\\label{{{}}}\n", caption(), label)
                 : fmt::format("\\caption{{As Table~\\ref{{{}}}, of further series.}}\n", label));
  }

  std::string caption() const {
    const std::vector<std::string> problems = problems_of(study_);
    std::string text = latex_text(study_.title);
    if (!problems.empty())
      text += fmt::format(" (problem{} {})", problems.size() > 1 ? "s" : "",
                          latex_text(fmt::format("{}", fmt::join(problems, ", "))));
    text += fmt::format(". Errors are {}", norm_symbol(norm_).definition);
    if (const std::string trial = trial_sentence(study_); !trial.empty()) text += ". " + latex_text(trial);
    return text + (has_orders() ? ". " + words_on_orders() : ".");
  }

  std::string words_on_orders() const {
    std::string text = fmt::format(
        "The order beside an error is that in {} from the next usable error above to it; the last rows have the order "
        "fitted over a window with half of its 95\\,\\% interval (of three points half the difference of their two "
        "orders)",
        base_of_orders(study_.sweep));
    if (!fewer_.empty())
      text += "; a star marks fits that take fewer points than the window has: " +
              typeset(fmt::format("{}", fmt::join(fewer_, ", ")), Notation::latex);
    return text + ".";
  }

  std::string tabular(std::span<const Series* const> shown) const {
    const std::size_t width = has_orders() ? 2 : 1;
    std::string columns = "l", rules;
    std::vector<std::string> names{""}, heads{head_of_sweep(study_.sweep)};
    for (std::size_t k = 0; k < shown.size(); ++k) {
      columns += has_orders() ? "@{\\hspace{7pt}}r@{\\hspace{4pt}}r" : "@{\\hspace{7pt}}r";
      names.push_back(fmt::format("\\multicolumn{{{}}}{{c}}{{\\parbox[b]{{{}mm}}{{\\centering {}}}}}", width,
                                  has_orders() ? 23 : 17, typeset(shown[k]->name, Notation::latex)));
      rules += fmt::format("\\cmidrule(lr){{{}-{}}}", 2 + k * width, 1 + (k + 1) * width);
      heads.push_back(norm_symbol(norm_).symbol);
      if (has_orders()) heads.emplace_back("order");
    }
    std::string text = fmt::format("\\begin{{tabular}}{{@{{}}{}@{{}}}}\n\\toprule\n{}{}\n{}\\midrule\n", columns,
                                   latex_line(names), rules, latex_line(heads));
    for (const double x : levels_) text += latex_line(row_at(x, shown));
    return text + (has_orders() ? "\\midrule\n" + fitted_rows(shown) : "") + "\\bottomrule\n\\end{tabular}\n";
  }

  std::vector<std::string> row_at(double x, std::span<const Series* const> shown) const {
    std::vector<std::string> row{latex_cell(brief(x))};
    for (const Series* series : shown) {
      const auto point = std::ranges::find(series->points, x, &Point::x);
      row.push_back(point == series->points.end() ? none : error_text(*point));
      if (has_orders()) row.push_back(latex_cell(order_text(segment_order(*series, norm_, x), support::not_measured)));
    }
    return row;
  }

  std::string error_text(const Point& point) const {
    if (point.status != records::Status::ok) return to_string(point.status);
    return is_measured(point) ? latex_cell(in_three_digits(point.y.at(norm_))) : none;
  }

  /// "16 to 64 & 1.88 ± 0.18 & ...", a line for each window.
  std::string fitted_rows(std::span<const Series* const> shown) const {
    std::string text;
    for (const auto& window : windows_) {
      std::vector<std::string> row{
          fmt::format("{} to {}", latex_cell(brief(window.first)), latex_cell(brief(window.second)))};
      for (const Series* series : shown) {
        std::string fitted = none;
        for (const ObservedOrder& order : orders_of(*series))
          if (std::pair(order.from, order.to) == window)
            fitted = latex_cell(order_text(order)) + (takes_all(*series, order) ? "" : "$^*$");
        row.push_back(fmt::format("\\multicolumn{{2}}{{c}}{{{}}}", fitted));
      }
      text += latex_line(row);
    }
    return text;
  }

  const StudyResult& study_;
  const std::string norm_;
  std::vector<const Series*> series_;
  std::set<double> levels_;
  std::set<std::pair<double, double>> windows_;
  std::vector<std::string> fewer_;  ///< series whose fits take fewer points than their windows have
};

/// The norms that are fitted, and the errors that figures draw.
std::vector<std::string> norms_of(const StudyResult& study) {
  std::vector<std::string> norms;
  const auto add = [&](const std::string& norm) {
    const auto& known = records::norm_words();
    if (std::ranges::find(known, norm) == known.end() || std::ranges::find(norms, norm) != norms.end()) return;
    norms.push_back(norm);
  };
  for (const Series& series : study.series)
    for (const ObservedOrder& order : series.orders) add(order.norm);
  for (const records::Figure& figure : study.figures)
    if (figure.kind != records::Figure::Kind::particles) add(figure.quantity);
  return norms;
}

}  // namespace

std::string latex_convergence_tables(const StudyResult& study) {
  std::string text;
  for (const std::string& norm : norms_of(study)) text += ConvergenceTable(study, norm).text();
  return text;
}

}  // namespace mpmvv::reports
