#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <random>
#include <regex>
#include <thread>

#include "studies/store/schema.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::store_seal_test {

using records::StudyResult;

using namespace store_samples;
using testing::HasSubstr;
using testing::IsEmpty;

/// A study with a row in every table.
StudyResult full_study() {
  StudyResult s = study("full", "T", {series("a", {point(8, {{"own", 3}}), point(16)})});
  s.claims = {"S-fig10"};
  s.values = {{"v", 1.5, "m"}};
  s.parts = {{"S-fig10", "st", records::PartVerdict::holds, "e", "r", "order", 1, 2, {{"of 'a'", 1.5}}}};
  s.statements = {{"S-fig10", "O(h)", "S", "Fig. 10", "full"}};
  s.figures.resize(1);
  records::Figure& figure = s.figures[0];
  figure.name = "f", figure.series = figure.marks = {"a"}, figure.slopes = {2};
  figure.x_min = 1, figure.x_max = 2, figure.y_min = 3, figure.y_max = 4;
  records::Series& one = s.series[0];
  one.points[0].replicates = {{"own", {2.5, 3.5}}};
  one.orders = {{.norm = "l2",
                 .order = 2,
                 .segments = {{8, 16, 1.9}},
                 .floor = fits::FloorFit{1, 2, 3, 4, true, "r"},
                 .replicates = fits::ReplicateFit{25, 0.04, 0.1, 0.3}}};
  one.limit = fits::StabilityLimit{.key = "cfl", .stable = 0.5, .unstable = 1, .probes = {{0.5, true, "p"}}};
  one.extrapolations = {{"l2", 4, 64, 5, "model", 1.1, -0.5, 1e-3, 0.02, 0.1, 0.2, "remark"}};
  return s;
}

class SealedStore : public StoreTest {
 protected:
  void SetUp() override {
    Store store(file_, Store::Mode::create_or_write);
    records::Record failed = record(16);
    failed.status = records::Status::failed;
    failed.failure = records::Failure::of_case;
    for (const records::Record& r : {record(8), failed}) store.keep(r, provenance());
    store.keep_study(full_study(), {{bar(8), bar(16)}}, provenance());
  }

  /// All that a store tells of its contents, or what it complains of, and whether it finds itself unsound.
  struct Reading {
    std::string told;
    bool unsound;
  };

  /// Of one opening, which takes most of the time.
  Reading read(const std::filesystem::path& file) const {
    std::optional<Store> store;
    const std::string refused = complaint([&] { store.emplace(file, Store::Mode::read); });
    if (!store) return {"complaint: " + refused, true};
    std::string all;
    const std::string said = complaint([&] { all = all_of(*store); });
    bool unsound = false;
    const bool complains = !complaint([&] { unsound = !store->check().empty(); }).empty();
    return {said.empty() ? all : "complaint: " + said, unsound || complains};
  }

  static std::string all_of(const Store& store) {
    std::string all = store.export_csv();
    for (const StudyResult& s : store.studies("d1")) all += s.name + s.title + text_of(s);
    const Contents has = store.contents();
    all += fmt::format("{} {} {} {} {} {} {}", has.schema, has.bytes, has.studies, has.records, has.ok, has.unstable,
                       has.failed);
    for (const auto& [digest, commit, dirty, records, last] : has.programs)
      all += fmt::format("{} {} {} {} {}", digest, commit, dirty, records, last);
    for (const Version& v : store.versions()) all += v.digest + v.time;
    if (const auto found = store.find(bar(8), "d1")) all += fmt::format("{} {}", found->reason, found->error.l2);
    return all;
  }

  static std::string text_of(const StudyResult& s) {
    std::string text = s.text + s.sweep + to_string(s.kind);
    for (const records::Series& one : s.series) {
      text += one.name;
      for (const records::Point& p : one.points) {
        text += fmt::format("{} {} {}", p.x, to_string(p.status), p.reason);
        for (const auto& [quantity, value] : p.y) text += fmt::format("{}={} ", quantity, value);
      }
      for (const fits::ObservedOrder& o : one.orders)
        text += fmt::format("{} {} {} {}", o.norm, o.from, o.order, o.segments.size());
      if (one.limit) text += fmt::format("{} {} {}", one.limit->key, one.limit->stable, one.limit->probes.size());
      for (const fits::Extrapolation& e : one.extrapolations)
        text += fmt::format("{} {} {}", e.norm, e.limit, e.remark);
    }
    for (const records::Value& v : s.values) text += fmt::format("{} {} {}", v.name, v.value, v.meaning);
    for (const records::ClaimPart& p : s.parts) {
      text += p.claim + p.statement + p.evidence + to_string(p.verdict) + p.measure;
      text += fmt::format("{} {}", p.at_least.value_or(0), p.at_most.value_or(0));
      for (const records::Found& f : p.found)
        text += fmt::format("{} {} {} {} {}", f.what, f.value, f.lower, f.upper, f.remark);
    }
    for (const records::ClaimText& c : s.statements) text += c.statement + c.source + c.where + c.study;
    for (const records::Figure& f : s.figures)
      text += fmt::format("{} {} {} {}", f.name, f.caption, f.series.size(), f.slopes.size());
    return text;
  }
};

TEST_F(SealedStore, HoldsWhatIsWrittenOnly) {
  EXPECT_THAT(Store(file_, Store::Mode::read).check(), IsEmpty());
  Database(file_, Database::Access::write).execute("UPDATE runs SET l2 = l2 * 1.0000001 WHERE cells = 8");
  const Store store(file_, Store::Mode::read);
  EXPECT_THAT(store.check(), testing::ElementsAre(HasSubstr("row 1 of runs (bar) is not as it was written")));
  const std::vector<std::function<void()>> readers{[&] { store.find(bar(8), "d1"); }, [&] { store.studies("d1"); },
                                                   [&] { store.export_csv(); },
                                                   [&] { Store::merge(folder_ / "new.db", file_); }};
  for (const auto& reader : readers) EXPECT_THAT(complaint(reader), HasSubstr("is not as it was written"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new.db"));
  EXPECT_TRUE(store.find(bar(16), "d1")) << "what is intact is still read";
}

/// Of a table of the store: its column and a value of another kind than the column's.
TEST_F(SealedStore, EveryColumnIsUnderSealAndNoKindOfValueIsABug) {
  // Without STRICT, NOT NULL and CHECK a column takes anything; the statements that made the tables return afterwards.
  Database lax(file_, Database::Access::write);
  std::vector<std::pair<std::string, std::string>> tables;
  lax.each("SELECT name, sql FROM sqlite_schema WHERE type = 'table'", {},
           [&](const Row& row) { tables.emplace_back(row["name"].text(), row["sql"].text()); });
  const std::regex rules("STRICT,? ?|NOT NULL|CHECK \\([^()]*\\([^()]*\\)\\)| (INTEGER|TEXT|REAL)(?! PRIMARY)");
  std::vector<std::pair<std::string, std::string>> columns;
  lax.execute("PRAGMA writable_schema = ON");
  for (const auto& [name, sql] : tables) {
    lax.change("UPDATE sqlite_schema SET sql = ? WHERE name = ?", {std::regex_replace(sql, rules, " "), name});
    lax.each("SELECT name FROM pragma_table_info(?)", {name},
             [&, table = name](const Row& row) { columns.emplace_back(table, row["name"].text()); });
  }
  ASSERT_GT(columns.size(), 100U);
  const std::string damaged = folder_ / "damaged.db";
  for (const auto& [table, column] : columns)
    for (const char* value : {"NULL", "'x'", "-7.25", "x''"}) {
      std::filesystem::copy_file(file_, damaged, std::filesystem::copy_options::overwrite_existing);
      {
        Database database(damaged, Database::Access::write);
        database.execute(
            "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY; PRAGMA foreign_keys = OFF; "
            "PRAGMA writable_schema = ON");
        const auto changed = [&] {
          return database.change(
              fmt::format("UPDATE OR IGNORE {0} SET {1} = {2} WHERE {1} IS NOT {2}", table, column, value), {});
        };
        std::int64_t rows = 0;
        if (!complaint([&] { rows = changed(); }).empty() || rows == 0) continue;  // a key that takes no such value
        for (const auto& [name, sql] : tables)
          database.change("UPDATE sqlite_schema SET sql = ? WHERE name = ?", {sql, name});
      }
      const auto what = fmt::format("{}.{} = {}", table, column, value);
      EXPECT_NO_THROW(EXPECT_TRUE(read(damaged).unsound) << what) << what;
    }
}

TEST_F(SealedStore, NoFlippedBitChangesWhatIsReadUnseen) {
  const std::string sound = bytes_of(file_), told = read(file_).told;
  const auto damaged = folder_ / "damaged.db";
  std::mt19937 random(7);
  int seen = 0;
  for (int k = 0; k < 200; ++k) {
    std::string bytes = sound;
    const std::size_t at = random() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    std::ofstream(damaged, std::ios::binary) << bytes;
    const auto [now, unsound] = read(damaged);
    seen += unsound ? 1 : 0;
    EXPECT_TRUE(now == told || unsound) << "byte " << at << "\n" << now;
  }
  EXPECT_GT(seen, 0);
}

/// Another program keeps the last of many studies and forgets it again, while the others are checked.
TEST_F(SealedStore, IsSoundWhileAnotherProgramWrites) {
  StudyResult one = full_study();
  const auto keep = [&](Store& store, const std::string& name) {
    one.name = name;
    store.keep_study(one, {{bar(8), bar(16)}}, provenance());
  };
  Store store(file_, Store::Mode::write);
  for (int k = 0; k < 20; ++k) keep(store, fmt::format("study-{}", k));
  std::atomic<bool> is_checked = false;
  std::thread writer([&] {
    constexpr std::chrono::milliseconds so_that_others_read{20};
    for (Store other(file_, Store::Mode::write); !is_checked; std::this_thread::sleep_for(so_that_others_read)) {
      keep(other, "last");
      std::this_thread::sleep_for(so_that_others_read);
      other.forget("last");
    }
  });
  std::vector<std::string> faults;
  for (int k = 0; k < 5 && faults.empty(); ++k) faults = store.check();
  is_checked = true;
  writer.join();
  EXPECT_THAT(faults, IsEmpty());
}

}  // namespace mpmvv::store::store_seal_test
