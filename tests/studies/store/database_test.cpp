#include "studies/store/database.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/support/error.hpp"

namespace mpmvv::store::database_test {

/// Statements are prepared once and kept.
class KeptStatements : public testing::Test {
 protected:
  KeptStatements() { database_.execute("CREATE TABLE t (a INTEGER UNIQUE); INSERT INTO t VALUES (1), (2)"); }

  std::vector<std::string> columns() const {
    std::vector<std::string> names;
    database_.each("SELECT * FROM t LIMIT 1", {}, [&](const Row& row) { names = row.names(); });
    return names;
  }

  Database database_{"here", Database::Access::in_memory};
};

TEST_F(KeptStatements, RunWithinThemselves) {
  std::vector<std::int64_t> pairs;
  const std::string query = "SELECT a FROM t WHERE a >= ? ORDER BY a";
  database_.each(query, {1}, [&](const Row& outer) {
    database_.each(query, {2},
                   [&](const Row& inner) { pairs.push_back(10 * outer["a"].integer() + inner["a"].integer()); });
  });
  EXPECT_THAT(pairs, testing::ElementsAre(12, 22));
}

TEST_F(KeptStatements, SeeTablesThatHaveChanged) {
  EXPECT_THAT(columns(), testing::ElementsAre("a"));
  database_.execute("ALTER TABLE t ADD COLUMN b TEXT");
  EXPECT_THAT(columns(), testing::ElementsAre("a", "b"));
}

TEST_F(KeptStatements, RunAfterOneOfThemHasFailed) {
  const auto insert = [this](int a) { return database_.insert("t", {{"a", a}}); };
  EXPECT_EQ(insert(3), 1);
  EXPECT_THROW(insert(3), support::UsageError);
  EXPECT_EQ(insert(4), 1);
  database_.execute("DROP TABLE t");  // nothing reads it any more
}

}  // namespace mpmvv::store::database_test
