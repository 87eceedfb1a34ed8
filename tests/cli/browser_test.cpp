#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "goldens/golden.hpp"
#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"

/// The report's pages in a browser: tests/browser on a report with every kind of page. `./run nightly-tests` installs
/// what it takes.
namespace mpmvv::cli::browser_test {

const std::string source = MPMVV_SOURCE_DIR;

/// The studies of the quick gate, as a shell takes them.
std::string quick_studies() {
  std::istringstream lines(read_text(source + "/studies/quick.txt"));
  std::string files;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') files += " studies/" + line;
  return files;
}

/// The golden of an order of nearly two, which says nearly four instead.
std::string with_wrong_order(const std::string& text) {
  static const std::regex right("expected = 1([.][0-9]+)\nlower = 1([.][0-9]+)\nupper = 2([.][0-9]+)\n");
  return std::regex_replace(text, right, "expected = 3$1\nlower = 3$2\nupper = 4$3\n",
                            std::regex_constants::format_first_only);
}

/// Fast: goldens that are proposed anew have other numbers, and the tests below would see that at night.
TEST(BrowserGoldens, HaveAnOrderThatCanBeMadeWrong) {
  const std::string right = read_text(source + "/goldens/s-fig10.toml"), wrong = with_wrong_order(right);
  EXPECT_NE(wrong, right);
  EXPECT_NO_THROW(goldens::parse_goldens(wrong, "s-fig10.toml"));
  EXPECT_THAT(quick_studies(), testing::HasSubstr("studies/s-fig10.toml"));
}

/// A report of the quick gate's studies, one golden of which is wrong, in a store with an earlier version, with a
/// benchmark beside it.
class BrowserNightly : public testing::Test {
 protected:
  void SetUp() override {
    const std::string here = "cd '" + source + "' && ";
    ASSERT_EQ(call(folder_, "study" + quick_studies() + " --db " + db_, here).code, 0);
    add_earlier_version();
    folder_.write(
        "benchmark.json",
        nlohmann::json{{"context", {{"date", "2026-01-01"}, {"digest", store::current_provenance().digest}}},
                       {"benchmarks", {{{"run_name", "machine/triad"}, {"run_type", "iteration"}, {"bytes", 1.3e10}}}}}
            .dump());
    std::filesystem::copy(source + "/goldens", folder_ / "goldens");
    folder_.write("goldens/s-fig10.toml", with_wrong_order(read_text(source + "/goldens/s-fig10.toml")));
    const Answer report =
        call(folder_, "report --db " + db_ + " --out " + report_ + " --goldens " + (folder_ / "goldens"), here);
    ASSERT_EQ(report.code, 0) << report.err;
  }

  void add_earlier_version() const {
    store::Store store(db_, store::Store::Mode::write);
    store::Provenance earlier = store::current_provenance();
    const auto studies = store.studies(earlier.digest);
    earlier.digest = "00ff", earlier.commit = "c0ffee0123456789", earlier.time = "2001-01-01T00:00:00Z";
    for (records::StudyResult study : studies) {
      for (auto& series : study.series) {
        for (auto& order : series.orders) order.order += 0.01;
        series.points.clear();
      }
      store.keep_study(study, std::vector<std::vector<cases::Case>>(study.series.size()), earlier);
    }
  }

  const Folder folder_;
  const std::string db_ = folder_ / "r.db", report_ = folder_ / "report";
};

TEST_F(BrowserNightly, PagesWorkAndAreRead) {
  const Answer answer = shell("cd '" + source + "/tests/browser' && REPORT='" + report_ +
                              "' node --test --test-reporter=tap use.test.mjs look.test.mjs links.test.mjs 2>&1");
  EXPECT_EQ(answer.code, 0) << answer.out;
  EXPECT_THAT(answer.out, testing::HasSubstr("mutants.html"));
  EXPECT_THAT(answer.out, testing::HasSubstr("# fail 0"));
}

}  // namespace mpmvv::cli::browser_test
