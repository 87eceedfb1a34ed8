#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A number of each of eight points. Two vector registers of four: the logarithms of one alone take a third longer.
using Lanes = Eigen::Array<double, 8, 1>;

/// to[k] = at(X[k]), where `at` is given the coordinates of eight points and returns as many numbers of each. A point's
/// depend neither on its lane nor on the points beside it.
template <int D>
void in_lanes(std::span<const Vec<D>> X, Vec<D>* to, const auto& at) {
  constexpr std::size_t lanes = Lanes::SizeAtCompileTime;
  const auto evaluate = [&at](const Vec<D>* from, Vec<D>* values) {
    std::array<Lanes, D> place;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t d = 0; d < D; ++d) place[d].data()[lane] = from[lane].data()[d];
    const std::array<Lanes, D> value = at(place);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t d = 0; d < D; ++d) values[lane].data()[d] = value[d].data()[lane];
  };
  std::size_t k = 0;
  for (; k + lanes <= X.size(); k += lanes) evaluate(&X[k], to + k);
  if (k == X.size()) return;
  std::array<Vec<D>, lanes> from, values;  // what is missing at the end repeats the last
  for (std::size_t lane = 0; lane < lanes; ++lane) from[lane] = X[std::min(k + lane, X.size() - 1)];
  evaluate(from.data(), values.data());
  std::copy_n(values.begin(), X.size() - k, to + k);
}

}  // namespace mpmvv::mms
