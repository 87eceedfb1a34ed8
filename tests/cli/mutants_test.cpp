#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv {
namespace mutants_test {

using testing::HasSubstr;

const std::string tree = std::string(" --source '") + MPMVV_SOURCE_DIR + "'";

TEST(MutantsCommand, ListsThePlantedMistakes) {
  const Folder folder;
  const auto mistakes = call(folder, "mutants --list --json" + tree).json()["mistakes"];
  EXPECT_GE(mistakes.size(), 45U);
  for (const auto& mistake : mistakes) EXPECT_FALSE(mistake["what"].get<std::string>().empty());
}

TEST(MutantsCommand, BadInputIsNamed) {
  const Folder folder;
  const auto complaint = [&folder](const std::string& options) {
    const Answer answer = call(folder, "mutants " + options);
    EXPECT_EQ(answer.code, 2) << options;
    return answer.err;
  };
  const std::string db = " --db '" + (folder / "m.db") + "' --work '" + (folder / "work") + "'";
  EXPECT_THAT(complaint(tree), HasSubstr("no --db given"));
  EXPECT_THAT(complaint(db + " --source '" + (folder / "none") + "'"), HasSubstr("planted.toml"));
  EXPECT_THAT(complaint(db + " --random -1" + tree), HasSubstr("--random"));
  EXPECT_FALSE(std::filesystem::exists(folder / "m.db"));
}

}  // namespace mutants_test
}  // namespace mpmvv
