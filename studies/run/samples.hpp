#pragma once
#include <string>
#include <vector>

#include "studies/observed_order.hpp"
#include "studies/result.hpp"

namespace mpmvv {

/// The usable points of a series in one norm, with their step sizes: h = 1/x for a sweep over `cells`, else x.
inline std::vector<ErrorSample> samples_of(const Series& series, const std::string& norm, const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const Point& point : series.points)
    if (const auto y = point.y.find(norm); y != point.y.end() && point.status == Status::ok)
      samples.push_back({point.x, sweep == "cells" ? 1 / point.x : point.x, y->second});
  return samples;
}

/// The same of every replicate.
inline std::vector<ErrorSample> replicate_samples_of(const Series& series, const std::string& norm,
                                                     const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const Point& point : series.points)
    if (const auto all = point.replicates.find(norm); all != point.replicates.end())
      for (const double e : all->second) samples.push_back({point.x, sweep == "cells" ? 1 / point.x : point.x, e});
  return samples;
}

}  // namespace mpmvv
