#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/plan/study.hpp"
#include "tests/cli/small_study.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::study_refusal_test {

using store::store_samples::complaint;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Mistake {
  const char* from;  ///< text of the small study to replace
  const char* to;
  const char* message;
};

/// Each mistake alone gets one line with the file's name.
void expect_refused(std::initializer_list<Mistake> mistakes) {
  for (const Mistake& mistake : mistakes) {
    std::string text = cli::small_study;
    text.replace(text.find(mistake.from), std::string(mistake.from).size(), mistake.to);
    EXPECT_THAT(complaint([&] { parse_study(text, "bad.toml"); }),
                AllOf(HasSubstr("bad.toml:"), HasSubstr(mistake.message), Not(HasSubstr("\n"))));
  }
}

TEST(MistakeInAStudy, OfASettingIsNamed) {
  expect_refused({{"ppc = 4", "pcp = 4", "unknown key 'pcp'"},
                  {"\"bspline2\"\n[sweep]", "\"bspline7\"\n[sweep]", "unknown basis 'bspline7'"},
                  {"ppc = 4", "ppc = 0", "ppc = 0"},
                  {"cfl = 0.3", "cfl = \"fast\"", "cfl = 'fast'"},
                  {"ppc = 4", "ppc = 4\nrepeat = 1", "repeat = 1"},
                  {"title = \"Small\"", "title = 'Small", "bad.toml"}});
}

TEST(MistakeInAStudy, OfASweepOrALimitIsNamed) {
  expect_refused(
      {{"[8, 16, 32, 64]\n[[fit", "[]\n[[fit", "empty sweep"},
       {"[8, 16, 32, 64]\n[[fit", "[8, 16, 32, 64, -16]\n[[fit", "cells = -16"},
       {"[8, 16, 32, 64]\n[[fit", "[8, nan]\n[[fit", "nan"},
       {"name = \"bspline2\"", "name = \"linear\"", "series 'linear' twice"},
       {"name = \"bspline2\"", "name = \" \"", "'name' is blank in "},
       {"cells = [8, 16, 32, 64]", "steps = [4, 8, 16, 8.0]", "8 twice in the sweep over 'steps'"},
       {"basis = \"linear\"", "basis = \"linear\"\ncells = 8", "beside the sweep over it in "},
       {"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nscan_ratio = 1.0000001\n[sweep]\n", "scan_ratio"},
       {"[sweep]\ncells = [8, 16, 32, 64]", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1",
        "beside the search of its limit in "},
       {"[sweep]\ncells = [8, 16, 32, 64]", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"bspline2\"]",
        "is neither swept nor searched"},
       {"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\n[sweep]\n",
        "has no cells for series 'linear' (one `cells` in [fixed] or in the series; those of [sweep]"},
       {"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"cubic\"]\n[sweep]\n",
        "unknown series 'cubic'"},
       {"basis = \"linear\"\n[[series]]\nname = \"bspline2\"\n",
        "basis = \"linear\"\ncells = 8\n[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"linear\"]\n"
        "[[series]]\nname = \"bspline2\"\ncells = 8\n",
        "beside the sweep over it in "}});
}

TEST(MistakeInAStudy, OfAnAxisOrASlopeIsNamed) {
  const std::string figure = "[[figure]]\nname = \"new\"\ncaption = \"c\"\nxlabel = \"x\"\nylabel = \"y\"\n";
  const auto expect = [&](const std::string& keys, const std::string& message) {
    EXPECT_THAT(complaint([&] { parse_study(cli::small_study + ("\n" + figure + keys), "bad.toml"); }),
                AllOf(HasSubstr("bad.toml:"), HasSubstr(message), Not(HasSubstr("\n"))));
  };
  expect("y_range = [0, 1]", "begins at 0 on a logarithmic axis (above 0, or a linear yscale)");
  expect("x_range = [-5, 128]", "begins at -5 on a logarithmic axis (above 0, or a linear xscale)");
  expect("slopes = [0]", "slope 0 in ");
  expect("slopes = [1]\nyscale = \"linear\"", "'slopes' in ");
  expect("series = [\"linear\", \"linear\"]", "series 'linear' twice in ");
}

TEST(MistakeInAStudy, OfAKeyWithoutMeaningForParticlesIsNamed) {
  std::string study = cli::small_study;
  study.replace(study.find("cfl = 0.3\n"), 0, "particle_errors = true\n");
  study += "\n[[figure]]\nkind = \"particles\"\nname = \"p\"\ncaption = \"c\"\nxlabel = \"x\"\nylabel = \"y\"\n";
  EXPECT_NO_THROW(parse_study(study, "good.toml"));
  for (const std::string key : {"quantity", "xscale", "yscale"})
    EXPECT_THAT(
        complaint(
            [&] { parse_study(study + key + (key == "quantity" ? " = \"linf\"\n" : " = \"log\"\n"), "bad.toml"); }),
        AllOf(HasSubstr("'" + key + "' in bad.toml:"), HasSubstr("no meaning in a figure of kind 'particles'")));
}

TEST(MistakeInAStudy, OfReplicatesIsNamed) {
  expect_refused(
      {{"[[fit]]", "[replicates]\ncells = [1, 2]\n[[fit]]", "beside a limit or a sweep of another"},
       {"[[fit]]", "[replicates]\n[[fit]]", "beside a limit or a sweep of another"},
       {"[[fit]]", "[replicates]\nshuffle = [1, 2, 1]\n[[fit]]",
        "two replicates of series 'linear' are the same run in "},
       {"cfl = 0.3\n", "cfl = 0.3\nshuffle = 1\n[replicates]\nshuffle = [1, 2]\n", "beside its replicates in "},
       {"cfl = 0.3\n", "cells = 8\n[replicates]\nshuffle = [1, 2]\n", "beside the sweep over it in "},
       {"[[fit]]", "[replicates]\nshuffle = [1]\n[[fit]]", "fewer than two replicates"}});
}

TEST(MistakeInAStudy, OfAFitIsNamed) {
  expect_refused(
      {{"norm = \"l2\"\nwindow = [8, 64]\n[[figure", "norm = \"l3\"\nwindow = [8, 64]\n[[figure", "unknown norm 'l3'"},
       {"window = [8, 64]\n[[figure", "window = [64, 8]\n[[figure", "window"},
       {"window = [8, 64]\n[[figure", "window = [100, 200]\n[[figure",
        "ends at 100, which is no swept value (64 is the nearest)"},
       {"window = [8, 64]\n[[figure", "window = [8, 64.5]\n[[figure", "ends at 64.5, which is no swept value (64 is"},
       {"norm = \"l2\"\nwindow = [8, 64]\n[[figure", "norm = \"linf_all_steps\"\nwindow = [8, 64]\n[[figure",
        "without every_step"},
       {"window = [8, 64]\n[[figure", "window = [8, 64]\nfloor_window = [8, 64]\n[[figure", "holds 4 swept values"},
       {"[[fit]]", "[[extrapolate]]\nnorm = \"l2\"\nwindow = [8, 32]\n[[fit]]", "holds 3 swept values"}});
}

TEST(MistakeInAStudy, OfACriterionOrAClaimIsNamed) {
  expect_refused(
      {{"measure = \"order\"", "measure = \"ordre\"", "unknown measure 'ordre'"},
       {"claim = \"S-fig10\"", "claim = \"S-fig99\"", "unknown claim"},
       {"at_least = 1.5", "", "asks nothing"},
       {"at_least = 1.5", "at_least = 3\nat_most = 1", "nothing can be both"},
       {"[fixed]", "[[claim]]\nid = \"M 1\"\nstatement = \"s\"\n[fixed]", "id 'M 1' of a claim"},
       {"measure = \"order\"\nseries = [\"bspline2\"]\nnorm = \"l2\"\nwindow = [8, 64]",
        "measure = \"limit\"\nseries = [\"bspline2\"]", "which the study does not search"},
       {"measure = \"order\"", "measure = \"shown\"", "'series' in "},
       {"measure = \"order\"", "measure = \"error-ratio\"\nover = \"bspline2\"", "series 'bspline2' over itself"},
       {"measure = \"order\"", "measure = \"error-ratio\"\nover = \"lineer\"", "unknown series 'lineer'"},
       {"measure = \"order\"", "measure = \"cost-ratio\"\nover = \"linear\"", "`repeat` in every series"}});
}

/// As numbers without an interval times would hold in one session and fail in the next.
TEST(MistakeInAStudy, OfACriterionThatTakesTimesForExactIsNamed) {
  const auto with = [](const std::string& measure, const std::string& norms) {
    std::string text = cli::small_study;
    const auto replace = [&](const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    replace("ppc = 4", "ppc = 4\nrepeat = 3");
    replace("measure = \"order\"\nseries = [\"bspline2\"]\nnorm = \"l2\"",
            "measure = \"" + measure + "\"\nseries = [\"bspline2\"]\n" + norms);
    return complaint([&] { parse_study(text, "bad.toml"); });
  };
  const std::string time = "norm = \"ns_per_particle_step\"", over = "\nover = \"linear\"";
  for (const auto& [measure, norms] : {std::pair{"error-ratio", time + over},
                                       {"error", time},
                                       {"spread", time},
                                       {"order", time},
                                       {"cost-ratio", time + over},
                                       {"order-difference", time + "\nover_norm = \"l2\""},
                                       {"order-difference", "norm = \"l2\"\nover_" + time}})
    EXPECT_THAT(with(measure, norms), AllOf(HasSubstr("norm 'ns_per_particle_step' in bad.toml:"),
                                            HasSubstr(std::string("with measure '") + measure +
                                                      "', which has no interval for times (slope-")));
  for (const char* measure : {"slope-ratio", "slope-share"}) EXPECT_EQ(with(measure, time + over), "");
}

TEST(MistakeInAStudy, OfAFigureIsNamed) {
  expect_refused({{"caption", "quantity = \"l3\"\ncaption", "unknown quantity 'l3'"},
                  {"caption", "quantity = \"nodal_l2\"\ncaption", "without nodal_error"},
                  {"caption", "quantity = \"y\"\ncaption", "y for the curves of a check"},
                  {"caption", "kind = \"pie\"\ncaption", "unknown figure kind 'pie'"},
                  {"caption", "kind = \"work-precision\"\ncaption", "`repeat` in every series"},
                  {"caption", "kind = \"particles\"\ncaption", "without particle_errors = true in series 'linear'"},
                  {"[[fit]]",
                   "[[figure]]\nname = \"p\"\nkind = \"particles\"\ncaption = \"c\"\nxlabel = \"x\"\nylabel = "
                   "\"y\"\n[replicates]\nshuffle = [1, 2]\n[[fit]]",
                   "beside replicates in "}});
}

}  // namespace mpmvv::plan::study_refusal_test
