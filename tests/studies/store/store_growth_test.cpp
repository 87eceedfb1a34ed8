#include <chrono>

#include "studies/fits/median.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::store_growth_test {

using namespace store_samples;

class StoreGrowthNightly : public StoreTest {
 protected:
  static constexpr int studies = 40, points = 10;

  static void keep_version(Store& store, const std::string& digest) {
    std::vector<records::Record> runs;
    std::vector<cases::Case> cases;
    records::Series one = series("s");
    for (int cells = 1; cells <= points; ++cells) {
      runs.push_back(record(cells));
      cases.push_back(bar(cells));
      one.points.push_back(point(cells));
    }
    store.keep(runs, provenance(digest));
    for (int k = 0; k < studies; ++k) {
      records::StudyResult s = study(fmt::format("study{}", k), "", {one});
      s.text = std::string(8000, '#');
      store.keep_study(s, {cases}, provenance(digest));
    }
  }

  /// The time to read the first version, the median of five.
  static double seconds_to_read(const Store& store) {
    std::vector<double> seconds;
    for (int k = 0; k < 5; ++k) {
      const auto begin = std::chrono::steady_clock::now();
      EXPECT_EQ(store.studies("d1").size(), studies);
      seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return fits::median_of(seconds);
  }
};

TEST_F(StoreGrowthNightly, AVersionIsReadAlmostAsFastBesideSixtyOthers) {
  Store store(file_, Store::Mode::create_or_write);
  keep_version(store, "d1");
  const double alone = seconds_to_read(store);
  for (int version = 2; version <= 61; ++version) keep_version(store, fmt::format("d{}", version));
  EXPECT_LT(seconds_to_read(store) / alone, 4);
}

}  // namespace mpmvv::store::store_growth_test
