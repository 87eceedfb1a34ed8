#include "reports/plot_style.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "reports/chart.hpp"

namespace mpmvv::reports::plot_style_test {

constexpr int colours = 7;

/// CIE L*, 0 for black and 100 for white: what a grey copy keeps of a colour.
double lightness(int style, double whiteness = 0) {
  const std::string text = colour_of(style, whiteness);
  const auto rgb = std::stoul(text.substr(text.find('#') + 1, 6), nullptr, 16);
  const std::array<double, 3> weights{0.2126, 0.7152, 0.0722};
  double luminance = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = static_cast<double>((rgb >> (16 - 8 * k)) & 0xFF) / 255;
    luminance += weights[k] * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  return luminance > 216.0 / 24389 ? 116 * std::cbrt(luminance) - 16 : luminance * 24389 / 27;
}

TEST(PlotStyle, AGreyCopyTellsAllColoursApart) {
  for (int a = 0; a < colours; ++a)
    for (int b = 0; b < a; ++b) EXPECT_GT(std::abs(lightness(a) - lightness(b)), 8) << a << " and " << b;
}

TEST(PlotStyle, NeighboursInTheKeyDifferMost) {
  for (int a = 1; a < colours; ++a) EXPECT_GT(std::abs(lightness(a) - lightness(a - 1)), 18) << a;
}

TEST(PlotStyle, EveryColourStandsOutFromThePaper) {
  for (int a = 0; a < colours; ++a) EXPECT_LT(lightness(a), 80) << a;
  EXPECT_GT(lightness(0, 0.55), lightness(0));
}

TEST(PlotStyle, NoTwoOfManySeriesLookAlike) {
  std::set<std::tuple<std::string, int, std::string>> looks;
  std::set<std::pair<int, std::string>> without_colour;
  for (int style = 0; style < 30; ++style) {
    looks.insert({colour_of(style), marker_of(style).filled, dash_of(style)});
    without_colour.insert({marker_of(style).filled, dash_of(style)});
  }
  EXPECT_EQ(looks.size(), 30u);
  EXPECT_EQ(without_colour.size(), 30u) << "marker and dash alone";
  EXPECT_EQ(dash_of(plain_style), dash_of(0)) << "solid";
}

}  // namespace mpmvv::reports::plot_style_test
