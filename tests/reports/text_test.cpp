#include "reports/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace mpmvv::reports::text_test {

TEST(Text, ExactNumbersReadBackAsThemselves) {
  for (const double v : {0.1, 1.0 / 3, 6.02214076e23, 5e-324, -2.2250738585072014e-308})
    EXPECT_EQ(std::strtod(exact(v).c_str(), nullptr), v);
  EXPECT_EQ(exact(NAN), "");
}

TEST(Text, BriefNumbersHaveFourDigitsAndCountsAllOfTheirs) {
  EXPECT_EQ(brief(0.123456), "0.1235");
  EXPECT_EQ(brief(12345.6), "1.235e+04");
  EXPECT_EQ(brief(16384), "16384") << "a number of cells";
  EXPECT_EQ(brief(-32768), "-32768");
  EXPECT_EQ(brief(1234567), "1.235e+06");
  EXPECT_EQ(brief(INFINITY), "inf");
  EXPECT_EQ(brief(NAN), "–");
  EXPECT_EQ(window_text(8, 16384), "8 to 16384");
}

TEST(Text, ThreeDigitsHaveNoExponentThatHidesASize) {
  EXPECT_EQ(three_digits(0.02854), "0.0285");
  EXPECT_EQ(three_digits(8.2), "8.20");
  EXPECT_EQ(three_digits(-44), "-44.0");
  EXPECT_EQ(three_digits(99.96), "100");
  EXPECT_EQ(three_digits(123428.6), "123429");
  EXPECT_EQ(three_digits(NAN), "–");
}

TEST(Text, NumbersAndTheirAbsenceAreToldFromWords) {
  for (const char* text : {"1", "-2.50", "1.5e-03", "123429", "–"}) EXPECT_TRUE(is_number(text)) << text;
  for (const char* text : {"", "2.01 ± 0.04", "16 to 128", "bspline2", "1x", "- 1"})
    EXPECT_FALSE(is_number(text)) << text;
}

TEST(Text, OrderHasAnIntervalOnlyWhenThereIsOne) {
  EXPECT_EQ(order_text(2.012, 0.04), "2.01 ± 0.04");
  EXPECT_EQ(order_text(2.012, NAN), "2.01");
  EXPECT_EQ(order_text(-4e-8, NAN), "0.00");
  EXPECT_EQ(order_text(-0.006, NAN), "-0.01");
  EXPECT_EQ(order_text(NAN, NAN), "–");
  EXPECT_EQ(order_text(2.00012, 0.0004), "2.0001 ± 0.0004") << "never ± 0.00";
  EXPECT_EQ(order_text(1e-9, 3.2e-8), "0.0000 ± 3e-08");
  EXPECT_EQ(order_text(-0.3, 12.7), "-0.30 ± 12.70");
}

TEST(Text, NoOrderIsMinusZero) {
  EXPECT_EQ(order_text(-4e-8, 4e-8), "0.0000 ± 4e-08");
  EXPECT_EQ(order_text(-4e-5, 4e-4), "0.0000 ± 0.0004");
  EXPECT_EQ(order_text(-6e-5, 4e-4), "-0.0001 ± 0.0004");
  EXPECT_EQ(order_text(-0.004, 0.04), "0.00 ± 0.04");
}

TEST(Text, AFitHasTheIntervalThatItIsJudgedBy) {
  fits::ObservedOrder fit;
  fit.order = 2;
  EXPECT_EQ(order_text(fit), "2.00") << "neither of residuals nor of replicates";
  fit.half_width = 0.05;
  EXPECT_EQ(order_text(fit), "2.00 ± 0.05");
  fit.replicates.emplace();
  fit.replicates->half_width = 0.31;
  EXPECT_EQ(order_text(fit), "2.00 ± 0.31");
}

TEST(Text, LatexSpecialCharactersAreEscaped) {
  EXPECT_EQ(latex_text("a_b & 10% of #1 {x} $y$ ~ ^ \\"),
            "a\\_b \\& 10\\% of \\#1 \\{x\\} \\$y\\$ \\textasciitilde{} \\textasciicircum{} \\textbackslash{}");
  EXPECT_EQ(latex_text("Δt < h²"), "$\\Delta$t $<$ h$^2$");
  EXPECT_EQ(latex_text("Léon"), "Léon");
  EXPECT_EQ(latex_text("‖∥ℓ∂"), "$\\|$$\\|$$\\ell$$\\partial$");
  EXPECT_EQ(latex_text("h⁻¹²ₕ₊"), "h$^-$$^1$$^2$$_h$$_+$");
  EXPECT_EQ(latex_text("✓"), "[U+2713]");
  EXPECT_THAT(without_latex("a✓ ‖ ✗"), testing::ElementsAre("✓", "✗"));
  EXPECT_EQ(latex_text("a\nb"), "a b");
  EXPECT_EQ(latex_text("--set a-b --- 3"), "-{}-set a-b -{}-{}- 3") << "LaTeX makes dashes of them";
}

TEST(Text, SaysTheGrowthThatShowsInSoManySteps) {
  EXPECT_EQ(growth_text(18000), "0.15 %");
  EXPECT_EQ(growth_text(185), "16 %");
  EXPECT_EQ(growth_text(40), "100 %");
  EXPECT_EQ(growth_text(12), "900 %");
  EXPECT_EQ(growth_text(0), "");
}

}  // namespace mpmvv::reports::text_test
