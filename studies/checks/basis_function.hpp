#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "solver/basis/basis.hpp"

namespace mpmvv::checks {

/// One basis function of a node far from every face, as a function of the distance x from its node, in cells.
template <solver::Basis B>
class BasisFunction {
 public:
  explicit BasisFunction(B basis = {}) : basis_(basis) {}

  double weight(double x) const { return evaluate(x).first; }
  double gradient(double x) const { return evaluate(x).second; }

  /// Returns weight and gradient at x. `width` is the width of the particle in cells, for bases that take one.
  std::pair<double, double> evaluate(double x, double width = 1) const {
    constexpr int node = 100;
    double N[B::support], dN[B::support];
    const int first = basis_.evaluate({node + x, 2 * node, width}, N, dN);
    const int k = node - first;
    if (k < 0 || k >= B::support) return {0, 0};
    return {N[k], dN[k]};
  }

 private:
  B basis_;
};

/// Returns n + 1 equally spaced numbers from a to b.
inline std::vector<double> linspace(double a, double b, int n) {
  std::vector<double> x;
  for (int k = 0; k <= n; ++k) x.push_back(a + (b - a) * k / n);
  return x;
}

/// Random numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mpmvv::checks
