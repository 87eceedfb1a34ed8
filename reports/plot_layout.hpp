#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace mpmvv::reports {

inline constexpr double usual_ratio = 0.7;  ///< height to width of a figure in a paper, with labels

/// Sizes that a figure is laid out for, in points.
struct PageSize {
  double width = 540;
  double font = 9.75;     ///< of all texts
  double height = 322.5;  ///< of the axes and their labels
};

/// An entry of the key: its curve, and its text in lines that the sheet has room for.
struct KeyEntry {
  const Curve* curve = nullptr;
  std::vector<std::string> lines;
};

/// Where a row of the key stands: a sample of the curve from left to right, then text.
struct KeyPlace {
  double sample_left = 0, sample_right = 0, text_left = 0, y = 0;
};

/// Where the parts of a figure stand, in fractions of its width and height from its lower left corner. The key has the
/// sheet's lower end to itself: neither data nor a label of the axes reach into it.
struct Layout {
  PageSize page;
  std::vector<KeyEntry> key;
  int key_columns = 1, key_rows = 0;
  std::vector<std::string> x_label{1};  ///< in lines for which the page is wide enough
  std::vector<std::string> y_label;     ///< in lines that are no longer than the axis

  double key_height() const;  ///< in points
  double height() const { return page.height + key_height(); }
  double axes_left() const { return left / page.width; }
  double axes_bottom() const;
  double axes_top() const;
  double axes_right() const { return 1 - right / page.width; }
  double label_room() const;  ///< below the axes, in points: tics, label and a gap
  double x_label_at(std::size_t line) const;
  double y_label_at(std::size_t line) const;
  double title_above_axes(std::size_t lines_below) const;
  double shades_label_at() const;     ///< across, of the scale of colours
  KeyPlace key_place(int row) const;  ///< down the first column, then the next

  /// Whether both axes are long enough to be read. An axis of named rows always is, as it is made as long as the rows
  /// need.
  bool has_room() const;

  bool has_named_rows = false;
  double key_column = 0;  ///< width of a column of the key, in points

  std::vector<std::vector<std::string>> titles;  ///< of panels to scale, in lines, in the order of the chart's labels

  double left = 0, right = 0, top = 0;  ///< margins, in points
};

/// The layout of a chart in a report, where a pixel of 1/96 inch is 3/4 of a point. The margins at the sides are the
/// plotting program's.
Layout report_layout(const Chart& chart);

/// The layout of a chart in a column of a paper, with letters of this size, both in points. A height of the whole, in
/// points, counts where the chart leaves it open; at 0 it follows from the width.
Layout paper_layout(const Chart& chart, double width, double font, double height = 0);

/// The axes without the texts of tics that would touch their neighbours on a length, both in points: across, where the
/// first of two stays, and upright, where the upper one stays.
Axis with_room(Axis axis, double length, double font);
Axis with_room_upright(Axis axis, double length, double font);

}  // namespace mpmvv::reports
