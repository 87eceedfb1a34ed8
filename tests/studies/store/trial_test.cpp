#include "studies/store/trial.hpp"

#include <gtest/gtest.h>

namespace mpmvv::store::trial_test {

TEST(Trial, IsReadFromTheTextThatSaysIt) {
  for (const char* file : {"", "\n", "title = \"A\"", "title = \"A\"\n", "# Run with care\ntitle = \"A\"\n",
                           "title = \"A\"\n# Run with care", "a = 1\n# Run with cfl = 0.4\n",
                           "a = 1\n# Run with cfl = 0.4 in 2 of 2 series, or so\n"}) {
    EXPECT_EQ(trial_of(file), "") << file;
    const std::string once = with_trial(file, "shuffle = 3 in 2 of 2 series");
    EXPECT_TRUE(once.starts_with(file));
    EXPECT_EQ(without_trial(file), file);
    EXPECT_EQ(without_trial(with_trial(once, "ppc = 2 in 1 of 2 series")),
              once.substr(0, once.find("# mpmvv study --set: shuffle")));
    EXPECT_EQ(trial_of(once), "shuffle = 3 in 2 of 2 series") << file;
    EXPECT_EQ(trial_of(with_trial(once, "ppc = 2 in 1 of 2 series")),
              "shuffle = 3 in 2 of 2 series; ppc = 2 in 1 of 2 series");
  }
  EXPECT_EQ(trial_of(with_trial("a = 1\n", "name = x\ny")), "name = x\\ny") << "no value ends the line";
}

TEST(Trial, OfAnOlderStoreIsReadAsItsProgramWroteIt) {
  const std::string file = "title = \"A\"\n# Run with care\n";
  const std::string once = file + "# Run with shuffle = 3 in 2 of 2 series\n";
  EXPECT_EQ(trial_of(once), "shuffle = 3 in 2 of 2 series");
  EXPECT_EQ(without_trial(once), file);
  const std::string twice = once + "# Run with blowup_energy = a in b in 10 of 12 series\n";
  EXPECT_EQ(trial_of(twice), "shuffle = 3 in 2 of 2 series; blowup_energy = a in b in 10 of 12 series");
  EXPECT_EQ(without_trial(twice), file);
}

TEST(Trial, ItsSettingsAreReadOneByOne) {
  const auto settings = settings_of(
      "shuffle = 3 in 2 of 2 series; blowup_energy = a in b in 10 of 12 series; name = x; y in 1 of 2 series");
  ASSERT_EQ(settings.size(), 3U);
  EXPECT_EQ(settings[0].key, "shuffle");
  EXPECT_EQ(settings[0].value, "3");
  EXPECT_TRUE(settings[0].in_all);
  EXPECT_EQ(settings[1].value, "a in b");
  EXPECT_FALSE(settings[1].in_all);
  EXPECT_EQ(settings[2].value, "x; y");
  for (const char* none : {"", "care", "a = 1", "a = 1 in 2", "a = 1 in 2 of 2 series, or so", " = 1 in 2 of 2 series"})
    EXPECT_TRUE(settings_of(none).empty()) << none;
}

TEST(Trial, AnyLineMayBeLong) {
  const std::string value(200'000, 'x');
  EXPECT_EQ(trial_of("a = 1\n# Run with a = " + value), "");
  const std::string trial = "a = " + value + " in 1 of 2 series";
  EXPECT_EQ(trial_of(with_trial("a = 1\n", trial)), trial);
  ASSERT_EQ(settings_of(trial).size(), 1U);
  EXPECT_EQ(settings_of(trial)[0].value, value);
}

}  // namespace mpmvv::store::trial_test
