#pragma once
#include <string>
#include <vector>

#include "studies/claims/criterion.hpp"

namespace mpmvv::claims {

/// Where a number may lie: an order by its replicates or residuals, an error by its replicates, a limit by its bracket.
struct Interval {
  double lower, upper;
};

/// Numbers measured for a criterion. `missing` says why something cannot be judged; else it is empty.
struct Measured {
  struct Number {
    records::Found found;
    bool is_sure = true;  ///< false where something of the same series is missing, without which it may differ
  };

  std::vector<Number> numbers;
  std::string missing;

  void add(const std::string& what, double value, const std::string& remark = "") {
    add(what, value, {value, value}, remark);
  }
  void add(const std::string& what, double value, const Interval& interval, const std::string& remark = "") {
    numbers.push_back({{what, value, interval.lower, interval.upper, remark}});
  }

  void add_missing(const std::string& what) {
    if (!what.empty()) missing += (missing.empty() ? "" : "; ") + what;
  }

  /// Adds what was measured of one series.
  void append(const Measured& of_series) {
    for (const Number& number : of_series.numbers) {
      numbers.push_back(number);
      numbers.back().is_sure = of_series.missing.empty();
    }
    add_missing(of_series.missing);
  }
};

Measured measure(const Criterion& c, const records::StudyResult& result);

}  // namespace mpmvv::claims
