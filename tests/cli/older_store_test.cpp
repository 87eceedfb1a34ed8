#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "studies/store/schema.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli::older_store_test {

using testing::HasSubstr;

TEST(OlderStore, IsBroughtUpToDateWithoutARun) {
  const Folder folder;
  const std::string db = folder / "r.db";
  store::open_store(db, store::Store::Mode::create_or_write, store::migrations().first(14))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 'bars', 'd1', 3, '', '', '', '', '', NULL)");
  const std::string before = read_text(db);
  const Answer info = call(folder, "db info --db " + db);
  EXPECT_EQ(info.code, 2);
  EXPECT_THAT(info.err, HasSubstr("has the older schema 14"));
  EXPECT_THAT(info.err, HasSubstr("(`mpmvv db update` brings it up to date)"));
  const Answer unknown = call(folder, "db forget bats --db " + db);
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("; did you mean 'bars'? (known: bars)"));
  EXPECT_EQ(read_text(db), before) << "nothing is written";
  for (int twice = 0; twice < 2; ++twice) {
    const Answer update = call(folder, "db update --db " + db);
    EXPECT_EQ(update.code, 0) << update.err;
    EXPECT_EQ(update.out, db + " is up to date\n");
  }
  EXPECT_THAT(call(folder, "db info --db " + db).out, HasSubstr("studies   1\n"));
  EXPECT_EQ(call(folder, "db forget bars --db " + db).code, 0);
  EXPECT_EQ(call(folder, "db update --db " + (folder / "absent.db")).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "absent.db"));
}

}  // namespace mpmvv::cli::older_store_test
