#pragma once
#include <string>

#include "reports/chart.hpp"
#include "reports/plot_layout.hpp"
#include "reports/typeset.hpp"

/// The parts of a script for the plotting program.
namespace mpmvv::reports {

/// A number as the plotting program reads it.
std::string plot_number(double v);

/// The text on one line, without characters that no picture can hold.
std::string one_line(const std::string& text);

/// A text in a notation, in double quotes.
std::string quoted(const std::string& text, Notation notation);

/// What the `plot` command draws: boxes and rings below, lines, marks, the band of the unstable with its crosses. Empty
/// when there is nothing to draw.
std::string plot_elements(const Chart& chart, double mark_scale);

/// The key, each entry where the layout has it, before the `plot` command.
std::string placed_key(const Layout& layout, Notation notation, double mark_scale);

/// The point type that stands for a curve: filled, or a cross where nothing else of it is drawn.
int key_marker(const Curve& curve);

/// The data that plot_elements refers to: a block for each curve that has dots, for each rule, one for the boxes and
/// one for the band of the unstable, in the order in which it counts them. gnuplot would not count an empty block.
std::string plot_data(const Chart& chart);

}  // namespace mpmvv::reports
