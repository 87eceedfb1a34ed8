#include "reports/typeset.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace mpmvv::reports::typeset_test {

TEST(Typeset, PlainTextStays) {
  EXPECT_EQ(typeset("l = h/2, 4e-6 s", Notation::plain), "l = h/2, 4e-6 s");
}

TEST(Typeset, LatexSetsQuantitiesAsMathematicsAndUnitsUpright) {
  const std::vector<std::pair<std::string, std::string>> texts{
      {"x/h", "$x$/$h$"},
      {"y (m)", "$y$ (m)"},
      {"l = h/2, 4 PPC", "$l$ = $h$/2, 4 PPC"},
      {"sigma_xx (Pa)", "$\\sigma$$_{xx}$ (Pa)"},
      {"(x - x_p)/h", "($x$ $-$ $x$$_{p}$)/$h$"},
      {"wall depth d (cells)", "wall depth $d$ (cells)"},
      {"order k", "order $k$"},
      {"time step Δt", "time step $\\Delta$$t$"},
      {"t = 3T/8", "$t$ = 3$T$/8"},
      {"A = 0.1 R_O", "$A$ = 0.1 $R$$_{O}$"},
      {"FMPM(2), CFL_X 0.2", "FMPM(2), CFL$_{X}$ 0.2"},
      {"T = 1.25/c, 4e-6 s", "$T$ = 1.25/$c$, 4$\\cdot$10$^{-6}$ s"},
      {"8 x 8 cells of 1 us", "8 $\\times$ 8 cells of 1 $\\mu$s"},
      {"10^-3", "10$^{-3}$"},
      {"2·10^5", "2$\\cdot$10$^{5}$"},
      {"h^2", "$h$$^{2}$"},
      {"falls as h^2.", "falls as $h$$^{2}$."},
      {"h^1.5 and", "$h$$^{1.5}$ and"},
      {"‖u − u_h‖ in L², e_u", "$\\|$$u$ $-$ $u$$_{h}$$\\|$ in $L$$^2$, $e$$_{u}$"},
      {"L/h, Δt·c/h", "$L$/$h$, $\\Delta$$t$$\\cdot$$c$/$h$"},
      {"σ_xx of φ, 3 μs", "$\\sigma$$_{xx}$ of $\\varphi$, 3 $\\mu$s"},
      {"E_kin, h^p", "$E$$_{\\mathrm{kin}}$, $h$$^{p}$"},
      {"m_p (S m^-1 p)", "$m$$_{p}$ (S m$^{-1}$ $p$)"},
      {"u-u_h, p=2", "$u$-$u$$_{h}$, $p$=2"},
      {"acceleration (m/s²)", "acceleration (m/s$^2$)"}};
  for (const auto& [text, set] : texts) EXPECT_EQ(typeset(text, Notation::latex), set) << text;
}

TEST(Typeset, WordsAndNamesAreNoQuantities) {
  for (const char* text :
       {"a body at rest", "Compare S Fig. 9(a).", "W (A.2)", "bspline2, ghost nodes", "FLIP, 1D", "B2CPDI, 2.5 mm",
        "domain a", "USAVG+-bspline2", "Léon", "it's h-refined", "e.g. this, i.e. that", "B-splines", "2.5 m/s"})
    EXPECT_EQ(typeset(text, Notation::latex).find('$'), std::string::npos) << typeset(text, Notation::latex);
}

TEST(Typeset, KeysKeepTheGapBeforeTheOrderAndItsSign) {
  EXPECT_EQ(typeset("linear   -0.51 ± 0.23", Notation::latex), "linear\\quad $-$0.51 $\\pm$ 0.23");
  EXPECT_EQ(typeset("linear   -0.51", Notation::enhanced), "linear   −0.51");
}

TEST(Typeset, GnuplotsNotationHasNoMeaningInAText) {
  EXPECT_EQ(typeset("x_p/h", Notation::enhanced), "{/:Italic x}_{/:Italic p}/{/:Italic h}");
  EXPECT_EQ(typeset("10^-3", Notation::enhanced), "10^{-3}");
  EXPECT_EQ(typeset("linear_periodic {a} & b@", Notation::enhanced), "linear\\_periodic \\{a\\} \\& b\\@");
}

/// What is italic in LaTeX's mathematics is so in the other formats.
TEST(Typeset, TheSameIsItalicInAllFormats) {
  EXPECT_EQ(typeset("σ_xx", Notation::enhanced), "{/:Italic σ}_{/:Italic xx}");
  EXPECT_EQ(typeset("h^p, h^2", Notation::enhanced), "{/:Italic h}^{/:Italic p}, {/:Italic h}^{2}");
  EXPECT_EQ(typeset("E_kin", Notation::enhanced), "{/:Italic E}_{kin}");
  EXPECT_EQ(typeset("‖u − u_h‖", Notation::enhanced), "‖{/:Italic u} − {/:Italic u}_{/:Italic h}‖");
  EXPECT_EQ(typeset("Δt", Notation::enhanced), "Δ{/:Italic t}");
  EXPECT_EQ(typeset("μs", Notation::enhanced), "μs");
}

TEST(Typeset, LatexsOwnCommandsAreNone) {
  EXPECT_EQ(typeset("\\alpha", Notation::latex), "\\textbackslash{}alpha");
}

TEST(Typeset, LatexsOwnSignsAreEscaped) {
  EXPECT_EQ(typeset("50 % of $1 & #2_long", Notation::latex), "50 \\% of \\$1 \\& \\#2\\_long");
}

}  // namespace mpmvv::reports::typeset_test
