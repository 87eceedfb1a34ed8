#pragma once
#include <string>
#include <utility>
#include <vector>

#include "studies/study.hpp"

namespace mpmvv {

/// Numbers measured for a criterion, each with a label; `missing` when something cannot be judged.
struct Measured {
  std::vector<std::pair<std::string, double>> numbers;
  std::string missing;

  void add(const std::string& label, double value) { numbers.emplace_back(label, value); }
};

Measured measure(const Criterion& c, const StudyResult& result);

}  // namespace mpmvv
