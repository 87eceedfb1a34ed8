#pragma once
#include <string>
#include <vector>

#include "studies/study.hpp"

namespace mpmvv {

/// Numbers measured for a criterion; `missing` when something cannot be judged.
struct Measured {
  struct Number {
    std::string label;
    double value;
    std::string words;  ///< what people read instead of a number without end; else empty
  };

  std::vector<Number> numbers;
  std::string missing;

  void add(const std::string& label, double value, const std::string& words = "") {
    numbers.push_back({label, value, words});
  }
};

Measured measure(const Criterion& c, const StudyResult& result);

}  // namespace mpmvv
