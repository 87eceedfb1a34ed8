#include "reports/claim_picture.hpp"

#include <gtest/gtest.h>

/// Which figure a claim's card shows.
namespace mpmvv::reports::claim_picture_test {

records::Figure figure(const std::string& name, const std::vector<std::string>& series,
                       const std::string& quantity = "l2") {
  records::Figure f;
  f.name = name, f.series = series, f.quantity = quantity;
  return f;
}

class ClaimPicture : public testing::Test {
 protected:
  ClaimPicture() {
    study_.name = "conv", study_.claims = {"v-apic"};
    study_.figures = {figure("bases", {"FLIP", "CPDI"}), figure("stress", {}, "stress_error"),
                      figure("updates", {"FLIP", "APIC", "PIC"})};
    study_.figures.push_back(figure("work", {"APIC", "PIC"}));
    study_.figures.back().kind = records::Figure::Kind::work_precision;
    claim_.id = "v-apic";
  }

  /// The name of the picture where the claim has such a criterion.
  std::string shown(const std::string& criterion) {
    study_.text = "title = \"t\"\n[[criterion]]\nclaim = \"v-apic\"\n" + criterion;
    const std::vector<Section> sections{section()};
    const Picture* const picture = picture_of(claim_, sections);
    return picture == nullptr ? "" : picture->name;
  }

  Section section() const {
    Section section{&study_, {}, {}};
    for (const records::Figure& f : study_.figures) {
      section.pictures.emplace_back();
      section.pictures.back().name = prefix_ + f.name;
    }
    return section;
  }

  records::StudyResult study_;
  claims::Claim claim_;
  std::string prefix_;
};

TEST_F(ClaimPicture, ShowsTheSeriesAndTheNormOfTheCriterion) {
  EXPECT_EQ(shown("series = [\"APIC\"]\nover = \"PIC\"\nnorm = \"l2\"\n"), "updates");
  EXPECT_EQ(shown("series = [\"FLIP\"]\nnorm = \"l2\"\n"), "bases") << "the first of two";
  EXPECT_EQ(shown("series = [\"APIC\"]\nnorm = \"stress_error\"\n"), "stress") << "a figure of all series";
  EXPECT_EQ(shown("series = [\"APIC\"]\nnorm = \"l2\"\nmeasure = \"cost-ratio\"\n"), "work");
}

TEST_F(ClaimPicture, IsTheFirstWhereNoneShowsTheCriterion) {
  EXPECT_EQ(shown("series = [\"APIC\"]\nnorm = \"linf\"\n"), "bases");
  EXPECT_EQ(shown("measure = \"shown\"\n"), "bases");
  EXPECT_EQ(shown("this is no TOML"), "bases");
  study_.claims = {"another"};
  EXPECT_EQ(shown("series = [\"APIC\"]\nnorm = \"l2\"\n"), "");
}

TEST_F(ClaimPicture, ShowsMostOfTheCriteria) {
  EXPECT_EQ(shown("series = [\"FLIP\"]\nnorm = \"l2\"\n"
                  "[[criterion]]\nclaim = \"v-apic\"\nseries = [\"PIC\"]\nnorm = \"l2\"\n"
                  "[[criterion]]\nclaim = \"x\"\nseries = [\"CPDI\"]\nnorm = \"l2\"\n"),
            "updates");
}

TEST_F(ClaimPicture, OfTheClaimsOwnNameGoesBefore) {
  study_.figures.push_back(figure("v-apic", {"CPDI"}));
  EXPECT_EQ(shown("series = [\"APIC\"]\nover = \"PIC\"\nnorm = \"l2\"\n"), "v-apic");
}

TEST_F(ClaimPicture, IsFoundUnderItsStudysNameToo) {
  prefix_ = "conv~";
  EXPECT_EQ(shown("series = [\"APIC\"]\nover = \"PIC\"\nnorm = \"l2\"\n"), "conv~updates");
}

}  // namespace mpmvv::reports::claim_picture_test
