#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "studies/cases/case.hpp"

namespace mpmvv::plan {

/// How far studies have come; or how far one case has, with its steps in the place of cases.
struct Progress {
  std::size_t done = 0, total = 0;  ///< cases that are asked for by now, each once; searches of limits ask for more
  double seconds_left = 0;          ///< estimate
  std::string label;                ///< the case that has just finished
};

/// Estimates how long the remaining work takes. The measured times of finished cases correct the estimates.
class Remaining {
 public:
  void add(const cases::Case& c, double estimate);       ///< seconds on one core
  void expect(double seconds) { expected_ += seconds; }  ///< of cases that are not known yet; negative: now they are
  void finish(const cases::Case& c, double measured);    ///< seconds on one core

  double seconds(int jobs) const;

 private:
  std::map<cases::Case, double> estimates_;  ///< of what is left
  double expected_ = 0;
  double estimated_ = 0, measured_ = 0;  ///< of what has finished
};

}  // namespace mpmvv::plan
