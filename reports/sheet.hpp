#pragma once
#include <array>
#include <string>

#include "studies/support/words.hpp"

namespace mpmvv::reports {

using support::to_string;

/// What a figure for a paper is written as.
enum class Format { pdf, svg, tex };
constexpr std::array<const char*, 3> words_of(Format) {
  return {"pdf", "svg", "tex"};
}

/// The ending of such a file: ".pdf".
inline std::string ending_of(Format format) {
  return "." + to_string(format);
}

/// The size of a figure for a paper, and its letters.
struct Sheet {
  Format format = Format::pdf;
  double width = 84;          ///< mm
  double height = 0;          ///< mm, of axes, labels and key; 0: follows from the width
  std::string font = "Sans";  ///< of PDF and SVG; LaTeX sets its own
  double font_size = 8;       ///< points
};

}  // namespace mpmvv::reports
