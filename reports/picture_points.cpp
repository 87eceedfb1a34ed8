#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>

#include "reports/picture.hpp"
#include "reports/text.hpp"
#include "reports/unstable_band.hpp"

namespace mpmvv::reports {

using nlohmann::json;
using records::Series;
using records::StudyResult;

namespace {

constexpr std::size_t most_points = 1500;   ///< of a picture
constexpr std::size_t most_of_a_line = 50;  ///< of a line without markers

/// The box between the axes, in pixels.
struct Frame {
  double left = 0, right = 0, top = 0, bottom = 0;
};

/// The frame in gnuplot's SVG, which draws the border as a closed path of five places; none without one.
std::optional<Frame> frame_in(const std::string& svg) {
  static const std::regex border(
      R"(d='M([\d.]+),([\d.]+) L[\d.]+,([\d.]+) L([\d.]+),[\d.]+ L[\d.]+,[\d.]+ L[\d.]+,[\d.]+ Z)");
  std::smatch m;
  if (!std::regex_search(svg, m, border)) return std::nullopt;
  return Frame{std::stod(m[1]), std::stod(m[4]), std::stod(m[2]), std::stod(m[3])};
}

const Series* find_series(const StudyResult& study, const std::string& name) {
  const auto found = std::ranges::find(study.series, name, &Series::name);
  return found == study.series.end() ? nullptr : &*found;
}

/// The point that a dot shows: the one at its x or, where x is no swept value, the one that measured its value.
const records::Point* point_at(const Series& series, const Dot& dot) {
  const auto same_x = std::ranges::find(series.points, dot.x, &records::Point::x);
  if (same_x != series.points.end()) return &*same_x;
  const auto measured = std::ranges::find_if(series.points, [&](const records::Point& p) {
    return std::ranges::any_of(p.y, [&](const auto& y) { return y.second == dot.value; });
  });
  return measured == series.points.end() ? nullptr : &*measured;
}

std::string value_text(const Dot& dot, const records::Point* point) {
  if (dot.mark != Mark::unstable) return brief(dot.value);
  return point == nullptr || point->reason.empty() ? "unstable" : "unstable: " + point->reason;
}

/// Points by series, in the order in which they are added.
class Points {
 public:
  Points(const Chart& chart, const Frame& frame, const std::vector<SeriesCommand>& commands)
      : chart_(chart), frame_(frame), commands_(commands) {}

  void add(const std::string& series, const Dot& dot, const std::string& swept, const std::string& value) {
    if (dot.mark == Mark::absent || !holds(chart_, dot)) return;
    const double x = frame_.left + chart_.x.fraction(dot.x) * (frame_.right - frame_.left);
    const double y = frame_.bottom - chart_.y.fraction(dot.drawn) * (frame_.bottom - frame_.top);
    of(series)["points"].push_back({std::lround(x), std::lround(y), swept, value});
    ++count_;
  }

  std::string text(const std::string& key, const std::string& quantity) const {
    if (series_.empty() || count_ > most_points) return "";
    const json all{{"key", key}, {"quantity", quantity}, {"series", series_}};
    return all.dump(-1, ' ', false, json::error_handler_t::replace);
  }

 private:
  json& of(const std::string& series) {
    for (json& known : series_)
      if (known["name"] == series) return known;
    series_.push_back({{"name", series}, {"points", json::array()}});
    const auto command = std::ranges::find(commands_, series, &SeriesCommand::series);
    if (command == commands_.end()) return series_.back();
    series_.back()["command"] = command->text;
    if (!command->note.empty()) series_.back()["note"] = command->note;
    return series_.back();
  }

  const Chart& chart_;
  const Frame frame_;
  const std::vector<SeriesCommand>& commands_;
  json series_ = json::array();
  std::size_t count_ = 0;
};

/// Adds the probes of a stability map. Its rows are named after their series, and x is the probed value.
void add_probes(const Chart& chart, Points& points) {
  for (const Curve& curve : chart.curves)
    for (const Dot& dot : curve.dots) {
      const auto row = std::ranges::find(chart.y.tics, dot.drawn, &Tic::at);
      if (row != chart.y.tics.end())
        points.add(row->text, dot, fmt::format("{}", dot.x), dot.mark == Mark::unstable ? "unstable" : "stable");
    }
}

void add_curves(const Chart& chart, const StudyResult& study, Points& points) {
  for (const Curve& curve : chart.curves) {
    const Series* series = find_series(study, curve.name);
    if (series == nullptr) continue;
    const std::size_t step = curve.marked ? 1 : 1 + curve.dots.size() / most_of_a_line;
    for (std::size_t k = 0; k < curve.dots.size(); k += step) {
      const Dot& dot = curve.dots[k];
      const records::Point* point = point_at(*series, dot);
      points.add(curve.name, dot, point == nullptr ? "" : fmt::format("{}", point->x), value_text(dot, point));
    }
  }
}

std::string probed_key(const StudyResult& study) {
  for (const Series& series : study.series)
    if (series.limit) return series.limit->key;
  return study.sweep;
}

}  // namespace

std::string points_of(const Chart& chart, const std::string& svg, const StudyResult& study,
                      const std::vector<SeriesCommand>& commands) {
  const auto frame = frame_in(svg);
  if (!frame || chart.of_particles) return "";
  const bool is_map = chart.y.names;
  std::vector<SeriesCommand> own;
  std::ranges::copy_if(commands, std::back_inserter(own), [&](const SeriesCommand& c) { return c.is_probe == is_map; });
  Points points(chart, *frame, own);
  if (is_map) {
    add_probes(chart, points);
    return points.text(probed_key(study), "");
  }
  add_curves(chart, study, points);
  return points.text(study.sweep, chart.y.label);
}

}  // namespace mpmvv::reports
