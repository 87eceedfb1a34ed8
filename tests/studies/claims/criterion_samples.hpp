#pragma once
#include <cmath>
#include <optional>
#include <string>

#include "studies/claims/criterion.hpp"

namespace mpmvv::claims::criterion_samples {

using records::Series;
using records::Status;
using records::StudyResult;

/// e = h² on 8 to 64 cells, and a series twice as large that is unstable at 64.
inline StudyResult two_series() {
  StudyResult result;
  result.sweep = "cells";
  result.series = {Series{"good", {}, {}, {}}, Series{"bad", {}, {}, {}}};
  for (const double n : {8.0, 16.0, 32.0, 64.0}) {
    result.series[0].points.push_back({n, Status::ok, "", {{"l2", 1 / (n * n)}}});
    if (n < 64)
      result.series[1].points.push_back({n, Status::ok, "", {{"l2", 2 / (n * n)}}});
    else
      result.series[1].points.push_back({n, Status::unstable, "blown up", {}});
  }
  result.values = {{"round_off", 3e-16, "largest difference"}};
  fits::StabilityLimit limit;
  limit.key = "cfl", limit.stable = 0.99, limit.unstable = 1.01, limit.found = true;
  result.series[0].limit = limit;
  return result;
}

/// e = h² on 8 to 128 cells, larger by 2^scatter at every other level; order one more in `linf`.
inline StudyResult scattered(double scatter) {
  StudyResult result;
  result.sweep = "cells";
  result.series = {Series{"good", {}, {}, {}}};
  for (int k = 0; k < 5; ++k) {
    const double n = 8 * std::exp2(k), e = std::exp2(-2 * k + scatter * (k % 2));
    result.series[0].points.push_back({n, Status::ok, "", {{"l2", e}, {"linf", e / n}}});
  }
  return result;
}

inline Criterion criterion(Criterion::Kind kind, const std::string& series, std::optional<double> at_least,
                           std::optional<double> at_most) {
  Criterion c;
  c.claim = "S-fig10", c.kind = kind, c.series = {series}, c.norm = "l2", c.window = {8, 64};
  c.at_least = at_least, c.at_most = at_most;
  c.reason = "why not";
  return c;
}

/// Of "good" over 8 to 128.
inline records::PartVerdict verdict_of_order(const StudyResult& result, std::optional<double> at_least,
                                             std::optional<double> at_most) {
  Criterion c = criterion(Criterion::Kind::order, "good", at_least, at_most);
  c.window = {8, 128};
  return judge(c, result).verdict;
}

using Kind = Criterion::Kind;

}  // namespace mpmvv::claims::criterion_samples
