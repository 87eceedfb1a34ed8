#include "reports/plot_style.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace mpmvv::reports {

namespace {

/// Hues of Okabe and Ito's palette, told apart with any colour vision, with CIE lightnesses about ten apart, so that a
/// grey copy tells them apart as well; neighbours in the key differ most.
constexpr std::array<unsigned, 7> palette{0x0072B2, 0xF07F4A, 0x000000, 0x0A986E, 0x4A1466, 0x78C4F2, 0x9A1F2E};
constexpr std::array<Marker, 6> markers{{{7, 6}, {5, 4}, {9, 8}, {13, 12}, {11, 10}, {15, 14}}};
constexpr std::array<const char*, 5> dashes{"1", "(9,4)", "(3,3)", "(9,3,2,3)", "(14,3,3,3,3,3)"};

template <class Choices>
const auto& chosen(const Choices& choices, int number) {
  return choices[static_cast<std::size_t>(number) % choices.size()];
}

}  // namespace

Marker marker_of(const Style& style) {
  return style == plain_style ? markers[0] : chosen(markers, style.number);
}

bool is_hollow(const Style& style) {
  return style.member > 0;
}

std::string colour_of(const Style& style, double whiteness) {
  const unsigned rgb = style == plain_style ? 0x000000 : chosen(palette, style.number);
  unsigned mixed = 0;
  for (const int shift : {16, 8, 0}) {
    const double part = (rgb >> shift) & 0xFFu;
    mixed |= static_cast<unsigned>(std::lround(part + (255 - part) * whiteness)) << shift;
  }
  return fmt::format("lc rgb '#{:06X}'", mixed);
}

std::string dash_of(const Style& style) {
  if (style == plain_style) return fmt::format("dt {}", dashes[0]);
  return fmt::format("dt {}", chosen(dashes, style.member == Style::alone ? style.number : style.member));
}

std::string shade_stops() {
  return "0 '#E1CC55', 1 '#C3B369', 2 '#A59C74', 3 '#8A8678', 4 '#707173', 5 '#575D6D', 6 '#3B496C', 7 '#123570', "
         "8 '#00224E'";
}

}  // namespace mpmvv::reports
