#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::suggestion_test {

using testing::HasSubstr;

/// What was written, in a call or in place of a word of a study file, and what was meant.
struct Misspelt {
  const char* word;
  const char* meant;
  const char* arguments = "study s.toml --db r.db";
  const char* in_study = "";  ///< the word of the small study that was misspelt
};

void PrintTo(const Misspelt& misspelt, std::ostream* out) {
  *out << misspelt.word;
}

class Suggestion : public testing::TestWithParam<Misspelt> {};

TEST_P(Suggestion, NamesTheWordThatWasMeantAndTheKnownOnes) {
  const Misspelt& misspelt = GetParam();
  const Folder folder;
  std::string study = small_study;
  if (const std::string right = misspelt.in_study; !right.empty())
    study.replace(study.find(right), right.size(), misspelt.word);
  folder.write("s.toml", study);
  const Answer answer = call(folder, misspelt.arguments, "cd '" + (folder / "") + "' && ");
  EXPECT_EQ(answer.code, 2);
  const std::string word = std::string("'") + misspelt.word + "'";
  EXPECT_THAT(answer.err, testing::AllOf(HasSubstr("unknown "), HasSubstr(word), HasSubstr("(known: ")));
  EXPECT_THAT(answer.err, HasSubstr("; did you mean '" + std::string(misspelt.meant) + "'? (known: "));
}

INSTANTIATE_TEST_SUITE_P(
    , Suggestion,
    testing::Values(Misspelt{"stduy", "study", "stduy s.toml"}, Misspelt{"inf", "info", "db inf --db r.db"},
                    Misspelt{"--integratr", "--integrator", "run --integratr cd"},
                    Misspelt{"--bd", "--db", "gate --bd r.db"}, Misspelt{"--vrsion", "--version", "--vrsion"},
                    Misspelt{"BSpline3", "bspline3", "run --problem bar --basis BSpline3 --cells 8 --ppc 2 --cfl 0.1"},
                    Misspelt{"basis", "bases", "list basis"},
                    Misspelt{"amplitud", "amplitude",
                             "run --problem bar --cells 8 --ppc 2 --cfl 0.1 --param amplitud=1"},
                    Misspelt{.word = "pcp", .meant = "ppc", .in_study = "ppc"}));

}  // namespace mpmvv::cli::suggestion_test
