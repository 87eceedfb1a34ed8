#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"

/// What a report and a paper say of where their results come from.
namespace mpmvv::cli::origin_test {

using testing::AllOf;
using testing::HasSubstr;

/// Adds a study that a build with changes kept on another processor.
void add_study_from_elsewhere(const std::string& db) {
  store::Store store(db, store::Store::Mode::write);
  store::Provenance other = store::current_provenance();
  records::StudyResult study = store.studies(other.digest).at(0);
  study.name = "elsewhere";
  for (auto& series : study.series) series.points.clear();
  other.commit = "c0ffee0123456789", other.dirty = true, other.cpu = "another processor";
  store.keep_study(study, {{}, {}}, other);
}

TEST(Origin, IsThatOfTheResultsAndNotOfTheProgramThatWritesThem) {
  const Folder folder;
  const std::string db = store_of(folder), here = "cd '" + (folder / "") + "' && ";
  add_study_from_elsewhere(db);
  ASSERT_EQ(call(folder, "report --db r.db --out report", here).code, 0);
  EXPECT_THAT(read_text(folder / "report/index.html"),
              AllOf(HasSubstr("c0ffee012345-dirty"), HasSubstr("another processor"),
                    HasSubstr(store::current_provenance().cpu), HasSubstr("<td>1 study, the newest of ")));
  ASSERT_EQ(call(folder, "paper elsewhere --db r.db --out paper", here).code, 0);
  EXPECT_THAT(read_text(folder / "paper/main.tex"),
              AllOf(HasSubstr("c0ffee0123456789 with changes"), HasSubstr("processor & another processor "),
                    HasSubstr("results & 1 study, ")));
}

}  // namespace mpmvv::cli::origin_test
