#include "studies/fits/distributions.hpp"

#include <gtest/gtest.h>

namespace mpmvv::fits::distributions_test {

// Tables that any textbook of statistics has.
TEST(Distributions, AreThoseOfTheTables) {
  EXPECT_NEAR(student_t_95(1), 12.7062, 1e-4);
  EXPECT_NEAR(student_t_95(10), 2.2281, 1e-4);
  EXPECT_NEAR(student_t_99(6), 3.7074, 1e-4);
  EXPECT_NEAR(fisher_f_above(4.9646, 1, 10), 0.05, 1e-5);
  EXPECT_NEAR(fisher_f_above(6.2561, 5, 4), 0.05, 1e-5);
  EXPECT_NEAR(at_most_heads(0, 9), 1 / 512.0, 1e-12);
  EXPECT_NEAR(at_most_heads(1, 9), 10 / 512.0, 1e-12);
}

}  // namespace mpmvv::fits::distributions_test
