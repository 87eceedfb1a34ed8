#include <fmt/format.h>

#include <algorithm>

#include "solver/basis/bases.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"

namespace mpmvv::checks {

namespace {

using namespace solver;

constexpr double ugimp_length = 0.5;

/// The density of S §4.3 mapped to the grid and back, ρ(x) = Σ_i ρ_i N_i(x), ρ_i = m_i / Σ_p N_ip V_p, for a body of
/// unit density on [begin, begin + 10] cells with `ppc` particles per cell; lengths in cells.
template <class B>
class Density {
 public:
  Density(const B& basis, double begin, int ppc) : basis_(basis), body_end_(begin + 10) {
    for (int k = 0; k < 10 * ppc; ++k) {
      double N[B::support], dN[B::support];
      const int first = basis_.evaluate({offset + begin + (k + 0.5) / ppc, cells, ugimp_length}, N, dN);
      for (int j = 0; j < B::support; ++j) active_[first + j] |= N[j] > 0;
    }
  }

  double at(double x) const {
    double N[B::support], dN[B::support];
    const int first = basis_.evaluate({offset + x, cells, ugimp_length}, N, dN);
    double density = 0;
    for (int j = 0; j < B::support; ++j) density += active_[first + j] ? N[j] : 0;  // ρ_i = 1 on nodes with mass
    return density;
  }

  /// Returns how far the last node with mass lies beyond the body, in cells.
  double node_extent() const {
    int last = 0;
    for (int i = 0; i < cells; ++i)
      if (active_[i]) last = i;
    return last - offset - body_end_;
  }

  /// Returns how far the density field reaches beyond the body, in cells.
  double field_extent() const {
    double x = body_end_ + 5;
    while (x > body_end_ && !(at(x) > 0)) x -= 1e-3;
    return x - body_end_;
  }

 private:
  static constexpr int offset = 10, cells = 40;
  B basis_;
  double body_end_;
  bool active_[cells] = {};
};

/// Adds the largest extents over the position of the body in a cell, divided by the printed `reach`, and a curve of the
/// density.
template <class B>
void add_extents(CheckResult& result, const B& basis, const std::string& name, double reach) {
  double nodes = 0, field = 0;
  for (const double begin : linspace(0, 0.999, 333)) {
    const Density<B> density(basis, begin, 64);
    nodes = std::max(nodes, density.node_extent());
    keep_larger(field, density.field_extent());
  }
  result.add(name + "_nodes", nodes / reach,
             fmt::format("{}: farthest node with mass beyond the body over the printed {} h", name, reach));
  result.add(name + "_field", field / reach,
             fmt::format("{}: farthest non-zero density beyond the body over the printed {} h", name, reach));
  const Density<B> aligned(basis, 0, 4);
  const auto x = linspace(-3.5, 13.5, 850);
  std::vector<double> y;
  for (const double xi : x) y.push_back(aligned.at(xi));
  result.add_curve(name, x, y);
}

}  // namespace

/// Measures how far mapped density spreads beyond the body, claim S-fig7.
CheckResult check_density_extent() {
  CheckResult result;
  add_extents(result, Linear{}, "linear", 1);
  add_extents(result, BSpline2{}, "bspline2", 1.5);
  add_extents(result, BSpline3{}, "bspline3", 2);
  add_extents(result, UGimp{ugimp_length}, "ugimp", 1 + ugimp_length / 2);
  result.add_curve("body", {-3.5, 0, 0, 10, 10, 13.5}, {0, 0, 1, 1, 0, 0});
  return result;
}

}  // namespace mpmvv::checks
