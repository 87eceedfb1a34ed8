#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "studies/cases/case.hpp"

namespace mpmvv::plan {

/// How far studies have come; with the steps of a case in the place of cases, how far that has.
struct Progress {
  std::size_t done = 0, total = 0;  ///< cases that are asked for by now; searches of limits ask for more
  double seconds_left = 0;          ///< about
  std::string label;                ///< the case that has just finished
};

/// How long what is left will take, by estimates that the times of what has finished correct.
class Remaining {
 public:
  void add(const cases::Case& c, double estimate);       ///< seconds on one core
  void expect(double seconds) { expected_ += seconds; }  ///< of what is not known by its cases yet; negative: it is now
  void finish(const cases::Case& c, double measured);    ///< seconds on one core

  double seconds(int jobs) const;

 private:
  std::map<cases::Case, double> estimates_;  ///< of what is left
  double expected_ = 0;
  double estimated_ = 0, measured_ = 0;  ///< of what has finished
};

}  // namespace mpmvv::plan
