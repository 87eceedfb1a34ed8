#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "mms/solution.hpp"

namespace mpmvv::mms {

/// One number for each of eight points, in two vector registers of four. With one register alone, logarithms take a
/// third longer.
using Lanes = Eigen::Array<double, 8, 1>;

/// Return the sine and cosine of each of the eight, to four units in the last place.
Lanes sin(const Lanes& angles);
Lanes cos(const Lanes& angles);

/// Sets to[k] = at(X(k)) for all k < `count`. `at` takes the D coordinates of eight points in lanes and returns D
/// numbers of each. The numbers of a point depend neither on its lane nor on the other points.
template <int D>
void in_lanes(std::size_t count, const auto& X, Vec<D>* to, const auto& at) {
  constexpr std::size_t lanes = Lanes::SizeAtCompileTime;
  const auto evaluate = [&at](const auto& from, Vec<D>* values) {
    std::array<Lanes, D> place;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t d = 0; d < D; ++d) place[d].data()[lane] = from(lane).data()[d];
    const std::array<Lanes, D> value = at(place);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t d = 0; d < D; ++d) values[lane].data()[d] = value[d].data()[lane];
  };
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes)
    evaluate([&](std::size_t lane) -> const Vec<D>& { return X(k + lane); }, to + k);
  if (k == count) return;
  std::array<Vec<D>, lanes> values;  // lanes beyond the last point repeat it
  evaluate([&](std::size_t lane) -> const Vec<D>& { return X(std::min(k + lane, count - 1)); }, values.data());
  std::copy_n(values.begin(), count - k, to + k);
}
template <int D>
void in_lanes(std::span<const Vec<D>> X, Vec<D>* to, const auto& at) {
  in_lanes<D>(
      X.size(), [X](std::size_t k) -> const Vec<D>& { return X[k]; }, to, at);
}

}  // namespace mpmvv::mms
