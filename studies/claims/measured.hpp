#pragma once
#include <string>
#include <vector>

#include "studies/claims/criterion.hpp"

namespace mpmvv::claims {

/// Where a number may lie: an order by its replicates or residuals, a limit by its bracket.
struct Interval {
  double lower, upper;
};

/// Numbers measured for a criterion. `missing` says why something cannot be judged; else it is empty.
struct Measured {
  struct Number {
    std::string label;
    double value;
    Interval interval;        ///< the value alone where no uncertainty is known
    std::string words;        ///< what people read instead of the bare number; else empty
    std::string remark = {};  ///< stands behind the label
  };

  std::vector<Number> numbers;
  std::string missing;

  void add(const std::string& label, double value, const std::string& words = "") {
    numbers.push_back({label, value, {value, value}, words});
  }
  void add(const std::string& label, double value, const Interval& interval, const std::string& remark = "") {
    numbers.push_back({label, value, interval, "", remark});
  }
};

Measured measure(const Criterion& c, const records::StudyResult& result);

}  // namespace mpmvv::claims
