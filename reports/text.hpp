#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "studies/fits/observed_order.hpp"

namespace mpmvv::reports {

/// A number for machines: 17 significant digits, nothing for NaN.
std::string exact(double v);

/// A number for people: four significant digits, a whole one below a million with all of its digits, as of 16384 cells;
/// a dash for NaN.
std::string brief(double v);

/// "16 to 128".
std::string window_text(double from, double to);

/// For people: three significant digits, all of those before the point, a dash for NaN.
std::string three_digits(double v);

/// "16 %": the least growth per step that shows in so many (fits::least_visible_growth); empty where they are 0.
std::string growth_text(std::int64_t steps);

/// Whether this is a number, or the dash for one that was not measured.
bool is_number(const std::string& text);

/// "2.01 ± 0.04"; without ± when the half width is NaN; a dash when the order is.
std::string order_text(double order, double half_width);

/// The same of a fit, with the half width by which criteria and goldens judge it.
std::string order_text(const fits::ObservedOrder& fit);

/// Text that LaTeX prints as it stands. Greek letters and the usual mathematical signs become mathematics; a character
/// that plain pdflatex cannot set becomes its code point.
std::string latex_text(const std::string& text);

/// The characters of the text that latex_text has no form for, in their order.
std::vector<std::string> without_latex(const std::string& text);

/// The name of a file in LaTeX, for which a tilde is a space.
std::string latex_file(const std::string& name);

/// The text without what HTML and XML cannot hold: control characters, but for tabs and ends of lines, noncharacters
/// and bytes that are not UTF-8 become U+FFFD.
std::string marked_up_text(const std::string& text);

/// The text with its ASCII letters small.
std::string lower_case(std::string text);

/// The text with every occurrence of `from` replaced.
std::string replace_all(std::string text, const std::string& from, const std::string& to);

}  // namespace mpmvv::reports
