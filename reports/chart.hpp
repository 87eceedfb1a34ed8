#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "reports/axis.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// What a dot stands for: inside or outside a fit's window, blown up (a cross), or nothing to draw.
enum class Mark { inside, outside, unstable, absent };

struct Dot {
  double x = 0;
  double value = 0;  ///< as measured; NaN where it was not
  double drawn = 0;  ///< where the mark stands on the y axis
  Mark mark = Mark::inside;
  double shade = support::not_measured;  ///< its colour on the chart's scale, where its curve has squares
  double least_x = support::not_measured, most_x = support::not_measured;  ///< a bar from one to the other; NaN: none
};

/// How a curve is told from others: by a number of its own, or as a member of a group that shares colour and marker,
/// the first solid and filled, the second dashed and hollow, the third dotted and hollow.
struct Style {
  int number = 0;
  int member = alone;

  static constexpr int alone = -1;
  constexpr Style(int own) : number(own) {}
  constexpr Style(int group, int in_group) : number(group), member(in_group) {}
  friend bool operator==(const Style&, const Style&) = default;
};

inline constexpr Style plain_style = -1;

struct Curve {
  std::string name;  ///< in the data file
  std::string key;   ///< in the key
  Style style = 0;
  bool joined = true;      ///< a line from dot to dot
  bool marked = true;      ///< a marker on each dot
  bool emphasised = true;  ///< the line itself is the result, not a guide to the eye
  std::vector<Dot> dots;
  double size = 0.8;  ///< of the markers
  double square = 0;  ///< width of the squares that dots are drawn as, in the axes' units, each in its shade; 0: none
  std::size_t every = 1;  ///< one dot in so many has its marker, counted back from the last, if it is inside
};

inline constexpr double report_letter = 0.04, paper_letter = 0.06;

/// Whether the curve has an entry in the key.
inline bool has_key(const Curve& curve) {
  return !curve.key.empty() && !curve.dots.empty();
}

inline bool has_range(const Dot& dot) {
  return dot.least_x < dot.most_x;
}

/// Whether a dot of the curve has a range in x.
inline bool has_ranges(const Curve& curve) {
  return std::ranges::any_of(curve.dots, has_range);
}

struct Place {
  double x = 0, y = 0;
};

/// A line that is not data.
struct Rule {
  enum class Kind { fit, reference, triangle, floor, limit, front, frame };
  Kind kind = Kind::fit;
  Style style = 0;      ///< as the curve's; plain_style: black
  std::string meaning;  ///< in the data file
  std::vector<Place> path;
};

struct Label {
  enum class Side { centre, left, right };  ///< which side of the text stands at the place
  Place at;
  std::string text;
  Side side = Side::centre;
  bool formula = false;  ///< symbols in italics, powers as `h^2` raised
};

/// A box around a place, with its full widths.
struct Box {
  Place centre;
  double width_x = 0, width_y = 0;
};

/// A figure, ready to be drawn: in the axes' own units, free of any plotting program.
struct Chart {
  std::string name;
  std::string caption;
  std::string trial = {};            ///< a sentence behind the caption: what `study --set` changed; empty for no trial
  double width = 720, height = 430;  ///< of the axes and their labels, in pixels of 1/96 inch
  std::size_t right_margin = 2;      ///< in characters
  double letter = report_letter;     ///< height of a letter as a fraction of the y axis
  bool to_scale = false;             ///< one unit is as long along x as along y
  bool of_particles = false;         ///< places of particles, in panels side by side
  Axis x, y;
  double top_of_values = 0;  ///< where the values end below the band; counts with a band alone
  double band = 0;  ///< upper part of the y axis that has crosses of unstable runs in place of values, a fraction
  std::optional<Axis> shades;  ///< the scale of the dots' colours, drawn beside the axes
  std::vector<Curve> curves;
  std::vector<Rule> rules;
  std::vector<Box> boxes;  ///< drawn slightly shrunk, below the dots
  std::vector<Label> labels;
  std::vector<std::string> notes;      ///< how to read it
  std::vector<std::string> omissions;  ///< what of the results it leaves out, in sentences
};

/// One figure of a study: its points, fits, floors, limits and reference slopes.
Chart error_chart(const records::StudyResult& study, const records::Figure& figure, double letter = report_letter);

/// Every probe of every limit of a study, stable or not, one row per series.
Chart stability_map(const records::StudyResult& study, const records::Figure& figure);

/// Error against the measured cost: a curve for each series, and the Pareto front of all.
Chart work_chart(const records::StudyResult& study, const records::Figure& figure);

/// Particles and their voxels, one panel for each series, side by side and to scale.
Chart particle_chart(const records::StudyResult& study, const records::Figure& figure);

/// The particles of each series' last sound run in panels, each in a colour for its error; of a body along a line, the
/// errors against their places.
Chart particle_error_chart(const records::StudyResult& study, const records::Figure& figure);

/// The series that a figure draws, in its order; all of the study's when it names none.
/// Throws UsageError when the figure names a series that the study lacks.
std::vector<const records::Series*> figure_series(const records::StudyResult& study, const records::Figure& figure);

/// "Made with --set: ppc = 2 in 2 of 2 series."; empty for a study as its file has it.
std::string trial_sentence(const records::StudyResult& study);

/// All figures of a study. One of kind `limit` gets a stability map at least: a figure without values is drawn as
/// one, and where there is none it is added under the name STUDY-map. A letter's height is a fraction of the y axis.
std::vector<Chart> charts_of(const records::StudyResult& study, double letter = report_letter);

/// The figures of all studies, a list for each study, under names that no two share: STUDY~NAME where studies share
/// one. Throws UsageError where a name of a study or figure cannot be the name of a file.
std::vector<std::vector<Chart>> charts_of_all(const std::vector<records::StudyResult>& studies,
                                              double letter = report_letter);

}  // namespace mpmvv::reports
