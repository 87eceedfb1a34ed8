#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings::refusal_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// "key=value ...", on 8 cells with 2 particles each, as options of the program give them.
void make(const std::string& text) {
  std::map<std::string, std::string> chosen{{"cells", "8"}, {"ppc", "2"}};
  std::istringstream words(text);
  for (std::string word; words >> word;) chosen[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  std::vector<Setting> settings;
  for (const auto& [key, value] : chosen) settings.push_back({key, value, "--" + key});
  make_case(settings);
}

struct Wrong {
  const char* settings;
  const char* message;
};

/// Each in one line.
void expect_refused(std::initializer_list<Wrong> all) {
  for (const Wrong& wrong : all)
    EXPECT_THAT([&] { make(wrong.settings); },
                testing::ThrowsMessage<support::UsageError>(AllOf(HasSubstr(wrong.message), Not(HasSubstr("\n")))))
        << wrong.settings;
}

TEST(Refusal, NamesAValueAndWhatIsAllowed) {
  expect_refused({{"problem=beam cfl=0.1", "unknown problem 'beam' in --problem (known: bar"},
                  {"problem=bar ppc=0 cfl=0.1", "ppc = 0 in --ppc (a whole number from 1"},
                  {"problem=bar cells=-8 cfl=0.1", "cells = -8 in --cells"},
                  {"problem=bar cells=8.5 cfl=0.1", "cells = 8.5 in --cells"},
                  {"problem=bar cfl=nan", "cfl = 'nan' in --cfl (a finite number)"},
                  {"problem=bar cfl=-0.1", "cfl = -0.1 in --cfl (a number > 0)"},
                  {"problem=bar cfl=1e308", "cfl = 1e308 in --cfl (a number from 1e-150 to"},
                  {"problem=bar cfl=0.1 repeat=2", "repeat = 2 in --repeat (a whole number"},
                  {"problem=bar cfl=0.1 param.amplitude=0.5", "allowed: between"},
                  {"problem=bar velocity_update=xpic order=0 cfl=0.1", "order = 0"},
                  {"problem=square cfl=0.1 param.amplitude=0.32", "between -1/pi and 1/pi"},
                  {"problem=cube cfl=0.1 param.poissons_ratio=0.5", "allowed: > -1 and < 0.5"}});
}

/// 100 characters are enough for each number.
TEST(Refusal, OfALongNumberDoesNotRepeatIt) {
  const std::string zeros(97, '0');
  EXPECT_NO_THROW(make("problem=bar cfl=0.1" + zeros));
  for (const std::string key : {"cfl", "cells", "param.amplitude"})
    EXPECT_THAT([&] { make("problem=bar cfl=0.1 " + key + "=8." + zeros + "00"); },
                testing::ThrowsMessage<support::UsageError>(key + " = 8.000000000000000000... in --" + key +
                                                            ", 101 characters (a number of at most 100)"));
}

TEST(Refusal, OfATimeStepSaysWhichWouldDo) {
  expect_refused({{"problem=bar", "neither cfl nor dt"},
                  {"problem=bar cfl=0.1 dt=1e-5", "both cfl and dt"},
                  {"problem=bar dt=3e-6", "does not divide the end time 0.01 s (the nearest that does: 3.00"}});
}

TEST(Refusal, OfParametersSaysWhichGoTogether) {
  expect_refused({{"problem=ring param.outer_radius=1.5", "three times"},
                  {"problem=ring param.amplitude=0.9", "det F"},
                  {"problem=vortex param.inner_radius=2", "not below"}});
}

TEST(Refusal, OfChoicesSaysWhyTheyDoNotGoTogether) {
  expect_refused(
      {{"problem=bar basis=bspline2-open boundary=periodic cfl=0.1", "has no ghost nodes"},
       {"problem=bar boundary=xmin=dirichlet cfl=0.1", "does not name face 'xmax'"},
       {"problem=bar boundary=xmin=periodic,xmax=free cfl=0.1", "one face only"},
       {"problem=bar boundary=xmin=free,xmin=free cfl=0.1", "'xmin' given twice in boundary of --boundary (once)"},
       {"problem=vortex quarter=true cfl=0.1", "which has no planes of symmetry (leave it out)"},
       {"problem=bar blowup_error=0 cfl=0.1", "blowup_error = 0 and blowup_energy = 10 (both > 0)"},
       {"problem=bar boundary=free wall_acceleration=difference cfl=0.1", "holds no node"},
       {"problem=bar basis=ugimp cfl=0.1", "without smoothing_length"},
       {"problem=bar integrator=usl start=half cfl=0.1", "no meaning for integrator 'usl'"},
       {"problem=bar boundary=dirichlet integrator=uvf wall_acceleration=difference cfl=0.1",
        "maps the velocity after"},
       {"problem=bar velocity_update=fmpm cfl=0.1",
        "velocity_update 'fmpm' without order (its k, from 1 on: --order 2"},
       {"problem=bar velocity_update=pic order=2 cfl=0.1", "no meaning"},
       {"problem=bar velocity_update=fmpm order=2 integrator=cd cfl=0.1", "at their ends"},
       {"problem=bar velocity_update=fmpm order=2 mass=consistent cfl=0.1", "nothing is expanded"},
       {"problem=impact nodal_error=true cells=4 cfl=0.2", "no exact acceleration"},
       {"problem=impact integrator=cd start=exact cells=4 cfl=0.2", "no exact velocity"},
       {"problem=impact material=neo-hookean-log cells=4 cfl=0.2", "it is of neo-hookean"},
       {"problem=ring param.poissons_ratio=0.3 cfl=0.1", "use conforming"}});
}

}  // namespace mpmvv::settings::refusal_test
