#pragma once
#include <string>
#include <vector>

#include "studies/claims/criterion.hpp"

namespace mpmvv::claims {

/// Where a number may lie: an order by its replicates or residuals, an error by its replicates, a limit by its bracket.
struct Interval {
  double lower, upper;
};

/// " (0.93 to 1.6)", with as many digits as tell the ends apart; " (without bounds)"; empty for less than round-off.
std::string range_text(const Interval& interval);

/// Numbers measured for a criterion. `missing` says why something cannot be judged; else it is empty.
struct Measured {
  struct Number {
    std::string label;
    double value;
    Interval interval;        ///< the value alone where no uncertainty is known
    std::string words;        ///< what people read instead of the bare number; else empty
    std::string remark = {};  ///< stands behind the label; without "; ", which parts the numbers of the evidence
    bool is_sure = true;      ///< false where something of the same series is missing, without which it may differ
  };

  std::vector<Number> numbers;
  std::string missing;

  void add(const std::string& label, double value, const std::string& words = "") {
    numbers.push_back({label, value, {value, value}, words});
  }
  void add(const std::string& label, double value, const Interval& interval, const std::string& remark = "") {
    numbers.push_back({label, value, interval, "", remark});
  }

  /// Adds what was measured of one series.
  void append(const Measured& of_series) {
    for (const Number& number : of_series.numbers) {
      numbers.push_back(number);
      numbers.back().is_sure = of_series.missing.empty();
    }
    if (!of_series.missing.empty()) missing += (missing.empty() ? "" : "; ") + of_series.missing;
  }
};

Measured measure(const Criterion& c, const records::StudyResult& result);

}  // namespace mpmvv::claims
