#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/chart.hpp"
#include "reports/original_look.hpp"
#include "reports/reference_slope.hpp"
#include "reports/series_style.hpp"
#include "reports/text.hpp"
#include "reports/unstable_band.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/window.hpp"

namespace mpmvv::reports {

using fits::ObservedOrder;
using records::Series;
using records::Status;

namespace {

constexpr std::size_t most_markers = 40;  ///< a curve with more points is a line without markers
constexpr double cross_row = 0.038;       ///< height, as a fraction of the axis

std::vector<const ObservedOrder*> orders_of(const Series& series, const std::string& norm) {
  std::vector<const ObservedOrder*> result;
  for (const auto& o : series.orders)
    if (o.norm == norm) result.push_back(&o);
  return result;
}

bool in_window(const ObservedOrder& o, double x) {
  return fits::Window{o.from, o.to}.holds(x);
}

/// Points of a series, from one to another, that have no place on the chart.
struct Missing {
  std::string series, why;
  double from = 0, to = 0;
  std::size_t last = 0;  ///< the last one's number among all points
};

/// Builds the chart of one figure; each step is one kind of thing on it.
class ErrorChart {
 public:
  ErrorChart(const records::StudyResult& study, const records::Figure& figure, double letter)
      : study_(study), figure_(figure), series_(figure_series(study, figure)), factor_(upwards_factor(figure)) {
    chart_.name = figure.name;
    chart_.caption = figure.caption;
    chart_.letter = letter;
  }

  Chart make() {
    const auto styles = series_styles(study_);
    for (const Series* s : series_) add_curve(*s, styles.at(s->name));
    set_axes();
    add_unstable_band(chart_, cross_row);
    note_clipped();
    for (const Series* s : series_) add_rules(*s, styles.at(s->name));
    if (figure_.log_x && figure_.log_y && has_values_)
      for (const double p : figure_.slopes) add_reference_slope(chart_, p, study_.sweep);
    add_notes();
    return std::move(chart_);
  }

 private:
  bool is_number_on(bool log, double v) const { return std::isfinite(v) && (!log || v > 0); }

  /// A value as the axis will have it: a factor of 100 makes per cent.
  std::string on_axis(double value) const { return brief(factor_ * value) + (factor_ == 100 ? " %" : ""); }

  /// Whether a fit says more than that its points lie on a line, as any two do; of a window of two levels, two are all.
  bool is_shown(const Series& s, const ObservedOrder& o) const {
    return o.points != 2 || std::ranges::count_if(s.points, [&](const auto& p) { return in_window(o, p.x); }) <= 2;
  }

  std::string key_of(const Series& s) const {
    std::string key = s.name, separator = "   ";
    for (const auto* o : orders_of(s, figure_.quantity))
      if (!std::isnan(o->order) && is_shown(s, *o)) {
        key += separator + order_text(*o);
        separator = ", ";
      }
    if (marks_limit(s))
      key += fmt::format("{}stable {} {}", separator, s.limit->stable < s.limit->unstable ? "to" : "from",
                         brief(s.limit->stable));
    return key;
  }

  bool marks_limit(const Series& s) const { return s.limit && s.limit->found && s.limit->key == study_.sweep; }

  /// Points that follow one another and lack a place for the same reason are said as one.
  void note_missing(const std::string& series, double x, const std::string& why) {
    if (!missing_.empty()) {
      Missing& before = missing_.back();
      if (before.series == series && before.why == why && before.last + 1 == point_) {
        before.to = x, before.last = point_;
        return;
      }
    }
    missing_.push_back({series, why, x, x, point_});
  }

  std::string text_of(const Missing& missing) const {
    const auto& [series, why, from, to, last] = missing;
    if (from == to) return fmt::format("{} at {} ({})", series, brief(from), why);
    return fmt::format("{} from {} to {} ({})", series, brief(from), brief(to), why);
  }

  Dot dot_of(const Series& s, const records::Point& p) {
    const auto y = p.y.find(figure_.quantity);
    const double value = y == p.y.end() ? NAN : y->second;
    Dot dot{p.x, value, value, Mark::inside};
    const auto orders = orders_of(s, figure_.quantity);
    const auto is_fitted = [&](const ObservedOrder* o) {
      return in_window(*o, p.x) && !claims::is_near_floor(p, figure_.quantity);
    };
    if (!orders.empty() && std::ranges::none_of(orders, is_fitted)) dot.mark = Mark::outside;
    if (p.status == Status::unstable) {
      dot.mark = Mark::unstable;
    } else if (p.status == Status::failed || !is_number_on(figure_.log_y, value)) {
      dot.mark = Mark::absent;
      const std::string why = p.status == Status::failed ? "failed"
                              : std::isnan(value)        ? "not measured"
                                                         : on_axis(value);
      note_missing(s.name, p.x, why);
    }
    return dot;
  }

  void add_curve(const Series& s, Style style) {
    const bool joined = std::ranges::find(figure_.marks, s.name) == figure_.marks.end();
    Curve curve{s.name, key_of(s), style, joined, s.points.size() <= most_markers, s.orders.empty(), {}};
    for (const auto& p : s.points) {
      ++point_;
      if (is_number_on(figure_.log_x, p.x))
        curve.dots.push_back(dot_of(s, p));
      else
        note_missing(s.name, p.x, "no place on this axis");
    }
    chart_.curves.push_back(std::move(curve));
  }

  void set_axes() {
    std::vector<double> xs, ys;
    for (const auto& curve : chart_.curves)
      for (const auto& dot : curve.dots) {
        if (dot.mark != Mark::absent) xs.push_back(dot.x);
        if (dot.mark == Mark::inside || dot.mark == Mark::outside) ys.push_back(dot.value);
      }
    for (const auto* s : series_) {
      if (marks_limit(*s)) xs.push_back(s->limit->value());
      for (const auto* o : orders_of(*s, figure_.quantity))
        if (o->floor && o->floor->accepted) ys.push_back(o->floor->floor);
    }
    has_values_ = !ys.empty();
    const bool has_markers = std::ranges::any_of(chart_.curves, &Curve::marked);
    const double side = has_markers ? 0.06 : 0;
    chart_.x = make_axis({figure_.xlabel.empty() ? study_.sweep : figure_.xlabel, figure_.log_x, figure_.x_min,
                          figure_.x_max, side, side, figure_.log_x},
                         xs);
    chart_.y = make_axis({figure_.ylabel.empty() ? figure_.quantity : figure_.ylabel, figure_.log_y, figure_.y_min,
                          figure_.y_max, figure_.slopes.empty() ? 0.06 : 0.14, 0.08},
                         ys);
  }

  void note_clipped() {
    for (const auto& curve : chart_.curves)
      for (const auto& dot : curve.dots) {
        ++point_;
        if (curve.marked && dot.mark != Mark::absent && !holds(chart_, dot))
          note_missing(curve.name, dot.x,
                       dot.mark == Mark::unstable ? "unstable, off the axes" : on_axis(dot.value) + " is off the axes");
      }
  }

  void add_rules(const Series& s, Style style) {
    for (const auto* o : orders_of(s, figure_.quantity)) {
      if (is_shown(s, *o)) add_fit(s, *o, style);
      if (o->floor && o->floor->accepted && is_number_on(figure_.log_y, o->floor->floor))
        chart_.rules.push_back({Rule::Kind::floor,
                                style,
                                fmt::format("{}: floor E0 of the fit with a floor", s.name),
                                {{chart_.x.from, o->floor->floor}, {chart_.x.to, o->floor->floor}}});
    }
    if (!marks_limit(s)) return;
    for (const double end : {s.limit->stable, s.limit->unstable})
      chart_.rules.push_back({Rule::Kind::limit,
                              style,
                              fmt::format("{}: stability limit", s.name),
                              {{end, chart_.y.from}, {end, chart_.y.to}}});
  }

  /// The power law from the first to the last point of its window.
  void add_fit(const Series& s, const ObservedOrder& o, Style style) {
    std::vector<records::Point> fitted;
    std::ranges::copy_if(s.points, std::back_inserter(fitted),
                         [&](const records::Point& p) { return p.status == Status::ok && in_window(o, p.x); });
    if (fitted.empty() || !std::isfinite(o.order) || !std::isfinite(o.constant)) return;
    const auto [first, last] = std::ranges::minmax(fitted, {}, &records::Point::x);
    if (!(first.x > 0 && first.x < last.x)) return;
    Rule rule{Rule::Kind::fit, style, fmt::format("{}: fit of {}, order {}", s.name, o.norm, exact(o.order)), {}};
    const double h = claims::step_size(first, study_.sweep), last_h = claims::step_size(last, study_.sweep);
    const int pieces = figure_.log_x && figure_.log_y ? 1 : 32;
    for (int k = 0; k <= pieces; ++k) {
      const double part = static_cast<double>(k) / pieces, h_here = h * std::pow(last_h / h, part);
      rule.path.push_back({first.x * std::pow(last.x / first.x, part), o.constant * std::pow(h_here, o.order)});
    }
    chart_.rules.push_back(std::move(rule));
  }

  void note_left_out() {
    for (const Series* s : series_)
      if (const std::string values = claims::left_out(*s, figure_.quantity); !values.empty() && !s->orders.empty())
        chart_.omissions.push_back(fmt::format("Left out of the order of {}: {}.", s->name, values));
  }

  void add_notes() {
    const auto rules = [&](Rule::Kind kind) {
      return std::ranges::find(chart_.rules, kind, &Rule::kind) != chart_.rules.end();
    };
    const auto marks = [&](Mark mark) {
      return std::ranges::any_of(
          chart_.curves, [&](const Curve& c) { return std::ranges::find(c.dots, mark, &Dot::mark) != c.dots.end(); });
    };
    std::string aid;
    if (rules(Rule::Kind::fit))
      aid += "Thick lines: fitted power laws over their windows, order ± half of its interval in the key. ";
    if (marks(Mark::outside)) aid += "Hollow points lie outside the window, or are left out. ";
    if (rules(Rule::Kind::reference)) aid += "Grey, with a triangle: reference slopes. ";
    if (rules(Rule::Kind::floor)) aid += "Dotted: floor of the fit with a floor. ";
    if (rules(Rule::Kind::limit)) aid += "Vertical lines: bracket of the stability limit. ";
    if (chart_.band > 0) aid += "Crosses in the band at the upper edge: unstable. ";
    if (!aid.empty()) chart_.notes.push_back(aid.substr(0, aid.size() - 1));
    note_left_out();
    if (missing_.empty()) return;
    constexpr std::size_t most = 6;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(most, missing_.size()); ++i) texts.push_back(text_of(missing_[i]));
    if (missing_.size() > most) texts.push_back(fmt::format("and {} more", missing_.size() - most));
    chart_.omissions.push_back(fmt::format("Without a point: {}.", fmt::join(texts, "; ")));
  }

  const records::StudyResult& study_;
  const records::Figure& figure_;
  std::vector<const Series*> series_;
  double factor_;
  std::vector<Missing> missing_;
  std::size_t point_ = 0;  ///< of all looked at, to know which follow one another
  bool has_values_ = false;
  Chart chart_;
};

}  // namespace

Chart error_chart(const records::StudyResult& study, const records::Figure& figure, double letter) {
  return ErrorChart(study, figure, letter).make();
}

}  // namespace mpmvv::reports
