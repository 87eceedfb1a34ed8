#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/panels.hpp"
#include "reports/particle_spacing.hpp"
#include "reports/series_style.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

using records::ParticleError;
using records::Point;
using records::Series;

namespace {

constexpr const char* error_label = "displacement error (m)";

/// A series at the last value at which it has errors of particles.
struct LastRun {
  const Series* series;
  const Point* point;

  const std::vector<ParticleError>& errors() const { return point->particle_errors; }
};

std::vector<LastRun> last_runs(const records::StudyResult& study, const records::Figure& figure) {
  std::vector<LastRun> runs;
  for (const Series* series : figure_series(study, figure)) {
    const auto last = std::find_if(series->points.rbegin(), series->points.rend(),
                                   [](const Point& p) { return !p.particle_errors.empty(); });
    if (last != series->points.rend()) runs.push_back({series, &*last});
  }
  return runs;
}

/// The scale of colours, from an error that nearly all particles exceed to the largest, so that a few errors near zero
/// do not take up the scale.
Axis shade_axis(const std::vector<LastRun>& runs) {
  std::vector<double> errors;
  for (const LastRun& run : runs)
    for (const ParticleError& one : run.errors())
      if (one.error > 0) errors.push_back(one.error);
  if (errors.empty()) {
    Axis axis = make_axis({std::string(error_label) + ", all 0", true, {}, {}}, errors);
    axis.tics = {{axis.from, ""}};
    return axis;
  }
  std::ranges::sort(errors);
  const double low = errors[errors.size() / 50];
  return make_axis({error_label, true, {}, {}}, std::vector{std::min(low, errors.back() / 2), errors.back()});
}

/// The panel of a run. Squares are as large as a particle's share of the body; where two overlap all the same, the
/// larger error is drawn later.
Panel panel_of(const LastRun& run) {
  Panel panel{run.series->name, {}};
  const double width = particle_spacing(run.errors());
  std::vector<ParticleError> sorted = run.errors();
  std::ranges::stable_sort(sorted, {}, &ParticleError::error);
  for (const ParticleError& one : sorted) {
    panel.particles.push_back({{one.x, one.y}, width, width});
    panel.shades.push_back(one.error);
  }
  return panel;
}

Chart shaded_panels(const records::Figure& figure, const std::vector<LastRun>& runs) {
  constexpr double axes_width = 560;
  constexpr std::size_t room_of_the_scale = 13;
  std::vector<Panel> panels;
  for (const LastRun& run : runs) panels.push_back(panel_of(run));
  Chart chart = panel_chart(figure, panels, axes_width);
  chart.right_margin = room_of_the_scale;
  chart.shades = shade_axis(runs);
  return chart;
}

/// The chart of a body along a line: the errors against their places.
Chart errors_along_a_line(const records::StudyResult& study, const records::Figure& figure,
                          const std::vector<LastRun>& runs) {
  constexpr std::size_t most_marked = 40;
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  std::vector<double> places, errors;
  const auto styles = series_styles(study);
  for (const LastRun& run : runs) {
    std::vector<ParticleError> sorted = run.errors();
    std::ranges::sort(sorted, {}, &ParticleError::x);
    Curve curve{
        run.series->name, run.series->name, styles.at(run.series->name), true, sorted.size() <= most_marked, true, {}};
    for (const ParticleError& one : sorted) {
      curve.dots.push_back({one.x, one.error, one.error, one.error > 0 ? Mark::inside : Mark::absent});
      places.push_back(one.x), errors.push_back(one.error);
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.x = make_axis({figure.xlabel, false, figure.x_min, figure.x_max, 0.02, 0.02}, places);
  const std::string label = figure.ylabel.empty() ? error_label : figure.ylabel;
  chart.y = make_axis({label, true, figure.y_min, figure.y_max, 0.06, 0.08}, errors);
  return chart;
}

/// Whether mirror images of what was run make a part of the body that has no particles here. Images by quarter turns,
/// and one mirror image alone in the plane, do have some.
bool lacks_mirror_images(const LastRun& run) {
  const auto images = run.point->y.find("images");
  const auto is_beside = [&](double ParticleError::*place) {  // on one side of the plane through the origin
    const auto [low, high] = std::ranges::minmax(run.errors(), {}, place);
    const double quarter = 0.25 * (high.*place - low.*place);
    return low.*place > -quarter || high.*place < quarter;
  };
  const bool is_line = std::ranges::all_of(run.errors(), [](const ParticleError& one) { return one.y == 0; });
  return images != run.point->y.end() && images->second > (is_line ? 1 : 2) &&
         (is_beside(&ParticleError::x) || is_beside(&ParticleError::y));
}

/// The series whose particles all have the error 0.
std::vector<std::string> without_error(const std::vector<LastRun>& runs) {
  std::vector<std::string> names;
  for (const LastRun& run : runs)
    if (std::ranges::none_of(run.errors(), [](const ParticleError& one) { return one.error > 0; }))
      names.push_back(run.series->name);
  return names;
}

/// The series of which nothing is drawn as no run is sound.
std::vector<std::string> never_sound(const records::StudyResult& study, const records::Figure& figure) {
  std::vector<std::string> names;
  for (const Series* series : figure_series(study, figure))
    if (!series->points.empty() &&
        std::ranges::none_of(series->points, [](const Point& p) { return p.status == records::Status::ok; }))
      names.push_back(series->name);
  return names;
}

/// Notes which runs the particles are of, and what is left out.
void add_notes(Chart& chart, const records::StudyResult& study, const records::Figure& figure,
               const std::vector<LastRun>& runs) {
  std::vector<std::string> which;
  for (const LastRun& run : runs)
    which.push_back(fmt::format("{} at {} {}", run.series->name, study.sweep, brief(run.point->x)));
  if (which.empty())
    chart.omissions.emplace_back("No run has errors of particles.");
  else
    chart.notes.push_back(fmt::format("At the end: {}.", fmt::join(which, "; ")));
  if (chart.shades)
    chart.notes.emplace_back(
        "Blue is a large error, yellow a small one. Squares are as large as a particle's share of the body; where they "
        "overlap, the largest error is on top, and larger ones behind them close gaps of a stretched body. Where "
        "particles are many, a square stands for neighbours, with their RMS error.");
  if (chart.shades && std::ranges::any_of(runs, [](const LastRun& run) { return run.errors().size() == 1; }))
    chart.notes.emplace_back("How large a lone particle is is not known: its square is a guess.");
  if (const auto names = without_error(runs); !names.empty())
    chart.omissions.push_back(fmt::format("The errors are exactly 0, {}: {}.",
                                          chart.shades ? "drawn like the smallest" : "which has no place on the axis",
                                          fmt::join(names, "; ")));
  if (const auto names = never_sound(study, figure); !names.empty())
    chart.omissions.push_back(
        fmt::format("Not drawn, as all its runs are unstable or failed: {}.", fmt::join(names, "; ")));
  if (std::ranges::any_of(runs, lacks_mirror_images))
    chart.omissions.emplace_back(
        "A part of the body was run; its mirror images in planes across the axes, which make the rest, are not drawn.");
}

}  // namespace

Chart particle_error_chart(const records::StudyResult& study, const records::Figure& figure) {
  const std::vector<LastRun> runs = last_runs(study, figure);
  const bool is_flat = std::ranges::all_of(runs, [](const LastRun& run) {
    return std::ranges::all_of(run.errors(), [](const ParticleError& one) { return one.y == 0; });
  });
  Chart chart = is_flat ? errors_along_a_line(study, figure, runs) : shaded_panels(figure, runs);
  add_notes(chart, study, figure, runs);
  return chart;
}

}  // namespace mpmvv::reports
