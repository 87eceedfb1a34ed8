#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reports/distinct.hpp"
#include "tests/reports/written_report.hpp"

namespace mpmvv::reports::read_back {

inline constexpr double close = 2e-3;  ///< relative; neighbouring values differ by far more

/// The first figure of a study, as a report draws it.
inline Drawing drawing_of(const records::StudyResult& study) {
  return WrittenReport(input_of(study)).drawing("Caption of " + study.name);
}

inline void expect_near(double read, double expected) {
  EXPECT_NEAR(read, expected, close * std::abs(expected));
}

}  // namespace mpmvv::reports::read_back
