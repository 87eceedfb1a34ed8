#include "reports/convergence_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <sstream>
#include <utility>

#include "reports/chart.hpp"
#include "reports/common_problem.hpp"
#include "reports/latex_table.hpp"
#include "reports/norm_symbol.hpp"
#include "reports/segment_order.hpp"
#include "reports/template_data.hpp"
#include "reports/text.hpp"
#include "reports/typeset.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::reports {

using fits::ObservedOrder;
using records::Point;
using records::Series;
using records::StudyResult;

namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::size_t abreast = 4, abreast_without_orders = 5;
constexpr std::size_t lines_on_page = 50, rows_of_piece = 40;
constexpr const char* none = "--";

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

/// How many lines a text takes whose words are broken into lines of so many letters.
std::size_t lines_of(const std::string& text, std::size_t letters) {
  std::istringstream words(text);
  std::size_t lines = 1, used = 0;
  for (std::string word; words >> word;) {
    if (used > 0 && used + 1 + word.size() > letters) ++lines, used = 0;
    used += (used > 0 ? 1 : 0) + word.size();
  }
  return lines;
}

/// How many lines a caption takes beyond those that every page has room for; at most half a page.
std::size_t lines_beyond_a_few(const std::string& caption) {
  constexpr std::size_t letters = 75, few = 6;
  return std::min(std::max(lines_of(caption, letters), few) - few, lines_on_page / 2);
}

using Window = std::pair<double, double>;

std::string name_of(const Window& window) {
  return window_text(window.first, window.second);
}

bool takes_all(const Series& series, const ObservedOrder& order) {
  return claims::points_text(series, order) == fmt::format("{}", order.points);
}

/// The table of one norm.
class ConvergenceTable {
 public:
  ConvergenceTable(const StudyResult& study, std::string norm) : study_(study), norm_(std::move(norm)) {
    std::set<double> levels;
    std::set<Window> windows;
    for (const Series& series : study.series) {
      const bool is_any_measured = std::ranges::any_of(series.points, [&](const Point& p) { return is_measured(p); });
      const bool is_any_sound = std::ranges::count(series.points, records::Status::ok, &Point::status) > 0;
      const bool has_only_failures = !series.points.empty() && !is_any_sound;
      if (series.points.size() > longest_shown || !(is_any_measured || has_only_failures)) continue;
      series_.push_back(&series);
      for (const Point& point : series.points) levels.insert(point.x);
      for (const ObservedOrder& order : orders_of(series)) {
        windows.insert({order.from, order.to});
        if (!takes_all(series, order))
          fewer_.push_back(fmt::format("{} ({})", series.name, claims::points_text(series, order)));
      }
    }
    levels_.assign(levels.begin(), levels.end());
    windows_.assign(windows.begin(), windows.end());
  }

  std::string text() const {
    if (series_.empty()) return "";
    const std::vector<Piece> pieces = pieces_of(most_abreast());
    const std::size_t on_page = std::max<std::size_t>(
        1, (lines_on_page - lines_beyond_a_few(caption())) / (pieces.front().lines() + lines_of_head()));
    std::string text;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (k % on_page == 0) text += (k > 0 ? "\\end{table}\n" : "") + beginning(pieces[k], k == 0);
      text += tabular(pieces[k]) + "\\par\\medskip\n";
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

  /// What stands in one tabular: some series, and of their rows as many as a page has room for.
  struct Piece {
    std::span<const Series* const> series;
    std::span<const double> levels;
    std::span<const Window> windows;

    std::size_t lines() const { return levels.size() + windows.size(); }
  };

  /// As few pieces as have room, about as large as each other.
  std::vector<Piece> pieces_of(std::size_t most_series) const {
    const auto size_of_parts = [](std::size_t all, std::size_t most) {
      const std::size_t parts = (all + most - 1) / most;
      return (all + parts - 1) / parts;
    };
    const auto some_of = [](const auto& all, std::size_t from, std::size_t count) {
      const std::size_t begin = std::min(from, all.size());
      return std::span(all).subspan(begin, std::min(count, all.size() - begin));
    };
    const std::size_t all_rows = levels_.size() + windows_.size();
    const std::size_t series = size_of_parts(series_.size(), most_series),
                      rows = size_of_parts(all_rows, rows_of_piece);
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < series_.size(); s += series)
      for (std::size_t r = 0; r < all_rows; r += rows) {
        const auto levels = some_of(levels_, r, rows);
        const std::size_t window = std::max(r, levels_.size()) - levels_.size();
        pieces.push_back({some_of(series_, s, series), levels, some_of(windows_, window, rows - levels.size())});
      }
    return pieces;
  }

  bool has_orders() const { return !windows_.empty(); }

  /// The width of a column's head, in mm.
  int head_width() const { return has_orders() ? 23 : 17; }

  /// How many lines the head of a piece takes: names, which are broken, symbols and rules.
  std::size_t lines_of_head() const {
    constexpr double letters_per_mm = 0.6;
    std::size_t names = 1;
    for (const Series* series : series_)
      names = std::max(names, lines_of(series->name, static_cast<std::size_t>(letters_per_mm * head_width())));
    return names + 3;
  }

  /// How many series stand abreast: fewer where the windows have long names.
  std::size_t most_abreast() const {
    constexpr std::size_t short_name = 11;
    const bool is_long = std::ranges::any_of(windows_, [&](const auto& w) { return name_of(w).size() > short_name; });
    return !has_orders() ? abreast_without_orders : is_long ? abreast - 1 : abreast;
  }

  std::string beginning(const Piece& piece, bool is_first) const {
    const std::string label = fmt::format("tab:{}-{}", template_data::anchor(study_.name), norm_);
    return fmt::format(
        "\n\\begin{{table}}[htbp]\n\\centering\\footnotesize\\setlength{{\\tabcolsep}}{{2pt}}\n{}\\par\\medskip\n",
        is_first ? fmt::format("\\caption{{{}}}\n\\label{{{}}}\n", caption(), label)
                 : fmt::format("\\caption{{As Table~\\ref{{{}}}, of further {}.}}\n", label,
                               piece.series.data() == series_.data() ? "rows" : "series"));
  }

  std::string caption() const {
    std::string text = latex_text(study_.title);
    if (const std::string problem = common_problem(study_, series_); !problem.empty())
      text += fmt::format(" (problem {})", latex_text(problem));
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

  std::string tabular(const Piece& piece) const {
    const auto shown = piece.series;
    const std::size_t width = has_orders() ? 2 : 1;
    std::string columns = "l", rules;
    std::vector<std::string> names{""}, heads{head_of_sweep(study_.sweep)};
    for (std::size_t k = 0; k < shown.size(); ++k) {
      columns += has_orders() ? "@{\\hspace{7pt}}r@{\\hspace{4pt}}r" : "@{\\hspace{7pt}}r";
      names.push_back(fmt::format("\\multicolumn{{{}}}{{c}}{{\\parbox[b]{{{}mm}}{{\\centering {}}}}}", width,
                                  head_width(), typeset(shown[k]->name, Notation::latex)));
      rules += fmt::format("\\cmidrule(lr){{{}-{}}}", 2 + k * width, 1 + (k + 1) * width);
      heads.push_back(norm_symbol(norm_).symbol);
      if (has_orders()) heads.emplace_back("order");
    }
    std::string text = fmt::format("\\begin{{tabular}}{{@{{}}{}@{{}}}}\n\\toprule\n{}{}\n{}\\midrule\n", columns,
                                   latex_line(names), rules, latex_line(heads));
    for (const double x : piece.levels) text += latex_line(row_at(x, shown));
    if (!piece.levels.empty() && !piece.windows.empty()) text += "\\midrule\n";
    return text + fitted_rows(piece) + "\\bottomrule\n\\end{tabular}\n";
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
  std::string fitted_rows(const Piece& piece) const {
    std::string text;
    for (const auto& window : piece.windows) {
      std::vector<std::string> row{
          fmt::format("{} to {}", latex_cell(brief(window.first)), latex_cell(brief(window.second)))};
      for (const Series* series : piece.series) {
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
  std::vector<double> levels_;
  std::vector<Window> windows_;
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
