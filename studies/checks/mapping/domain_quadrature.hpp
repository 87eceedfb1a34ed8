#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "studies/checks/mapping/particle_tiling.hpp"

namespace mpmvv::checks::mapping {

/// Gauss points in the boxes of the particles. The boxes are cut where pieces of nodal functions join (at nodes and
/// midway between them). So the quadrature is exact for polynomials of degree 5 along each axis on every piece. A
/// linear density times two basis functions is such a polynomial.
template <int D>
struct DomainQuadrature {
  Points<D> x;
  std::vector<double> dV;
  std::vector<Eigen::Index> particle;

  DomainQuadrature(const ParticleTiling<D>& tiling, const OverlayGrid<D>& grid) {
    for (std::size_t p = 0; p < tiling.x.size(); ++p) {
      std::array<Line, D> lines;
      for (int d = 0; d < D; ++d) {
        const double half = tiling.width[p][d] / 2, centre = tiling.x[p][d];
        lines[d] = cut_line(centre - half, centre + half, grid.lower[d], grid.h[d] / 2);
      }
      add_products(static_cast<Eigen::Index>(p), lines);
    }
  }

 private:
  using Line = std::vector<std::pair<double, double>>;  ///< abscissas and weights

  /// Returns three Gauss points on each part of [a, b] between multiples of `step` from `origin`.
  static Line cut_line(double a, double b, double origin, double step) {
    std::vector<double> ends{a};
    for (double k = std::ceil((a - origin) / step); origin + k * step < b; ++k) ends.push_back(origin + k * step);
    ends.push_back(b);
    Line line;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double middle = (ends[k] + ends[k + 1]) / 2, half = (ends[k + 1] - ends[k]) / 2;
      for (const double side : {-1.0, 1.0}) line.emplace_back(middle + side * std::sqrt(0.6) * half, half * 5 / 9);
      line.emplace_back(middle, half * 8 / 9);
    }
    return line;
  }

  void add_products(Eigen::Index p, const std::array<Line, D>& lines) {
    for (const auto& [along_x, weight_x] : lines[0]) {
      if constexpr (D == 1) {
        add(p, solver::Vec<1>(along_x), weight_x);
      } else {
        for (const auto& [along_y, weight_y] : lines[1]) add(p, {along_x, along_y}, weight_x * weight_y);
      }
    }
  }

  void add(Eigen::Index p, const solver::Vec<D>& at, double weight) {
    x.push_back(at);
    dV.push_back(weight);
    particle.push_back(p);
  }
};

}  // namespace mpmvv::checks::mapping
