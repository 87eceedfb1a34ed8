#include <gtest/gtest.h>

#include "studies/support/csv.hpp"

namespace mpmvv::support::csv_field_test {

TEST(CsvField, IsQuotedWhereItHasToBe) {
  EXPECT_EQ(csv_field("bspline2"), "bspline2");
  EXPECT_EQ(csv_field("bspline2, 4 PPC"), "\"bspline2, 4 PPC\"");
  EXPECT_EQ(csv_field("the \"half\" start"), "\"the \"\"half\"\" start\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, IsNoFormula) {
  for (const char* formula : {"=1+1", "+SUM(A1)", "-O3", "@SUM(A1)", "\t=1", "-", "-1e5x", "+1"})
    EXPECT_EQ(csv_field(formula), "'" + std::string(formula));
  EXPECT_EQ(csv_field("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  EXPECT_EQ(csv_field("\r=1"), "\"'\r=1\"");
}

TEST(CsvField, NumbersStay) {
  for (const char* number : {"-1", "-0.5", "-1.2500000000000001e-300", "-1e-9999", "7", "1e5"})
    EXPECT_EQ(csv_field(number), number);
}

}  // namespace mpmvv::support::csv_field_test
