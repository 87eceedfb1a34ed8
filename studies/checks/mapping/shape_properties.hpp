#pragma once
#include <algorithm>

#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/subject.hpp"

/// Properties of shapes. Each function returns a number that measures by how much a subject departs from a property of
/// B.
namespace mpmvv::checks::mapping {

/// Returns the largest |Φ_p(x_p + s) - Φ_p(x_p - s)| over the peak of Φ_p in the body.
template <int D>
double asymmetry_of(const Subject<D>& s, std::size_t p) {
  const Eigen::RowVectorXd phi = s.around(p, symmetric_offsets(s.body().grid()));
  return largest_of((phi - phi.reverse()).cwiseAbs()) / s.peak(p);
}

/// (v) Returns the asymmetry of the least symmetric interior particle.
template <int D>
double asymmetry(const Subject<D>& s) {
  double worst = 0;
  for (const std::size_t p : s.interior()) keep_larger(worst, asymmetry_of(s, p));
  return worst;
}

/// (v) Returns the asymmetry of the most symmetric interior particle.
template <int D>
double least_asymmetry(const Subject<D>& s) {
  double least = asymmetry(s);
  for (const std::size_t p : s.interior()) keep_smaller(least, asymmetry_of(s, p));
  return least;
}

/// Returns the largest difference of two shapes Φ_p(x_p + s) and Φ_q(x_q + s) of interior particles, over the peak in
/// the body. The pairs are those whole cells apart, or all others. `no_meaning` unless boxes are alike.
template <int D>
double largest_shape_difference(const Subject<D>& s, bool whole_cells_apart) {
  if (!s.body().tiling().boxes_are_alike()) return no_meaning;
  const auto& x = s.body().tiling().x;
  const auto offsets = symmetric_offsets(s.body().grid());
  double worst = 0;
  for (const std::size_t p : s.interior())
    for (const std::size_t q : s.interior()) {
      const solver::Vec<D> cells = (x[q] - x[p]).cwiseQuotient(s.body().grid().h);
      const bool whole = ((cells - cells.array().round().matrix()).array().abs() < 1e-9).all();
      if (q > p && whole == whole_cells_apart)
        keep_larger(worst, largest_of((s.around(p, offsets) - s.around(q, offsets)).cwiseAbs()) / s.peak(p));
    }
  return worst;
}

/// (vi) Returns the shape difference of particles at different places in their cells.
template <int D>
double shape_difference(const Subject<D>& s) {
  return largest_shape_difference(s, false);
}

/// (vi) Returns the shape difference of particles at the same place in their cells.
template <int D>
double shape_difference_in_phase(const Subject<D>& s) {
  return largest_shape_difference(s, true);
}

/// Returns for each element whether a row of `values`, taken at the points of the lattice, differs from zero at some
/// point in its interior by more than round-off of the largest value in the body.
template <int D>
std::vector<bool> elements_reached(const Subject<D>& s, const Eigen::RowVectorXd& values) {
  const double least = 1e-12 * values(s.in_body()).cwiseAbs().maxCoeff();
  std::vector<bool> reached(static_cast<std::size_t>(s.lattice().elements()));
  for (Eigen::Index k = 0; k < values.size(); ++k)
    if (const int e = s.lattice().element(static_cast<std::size_t>(k)); e >= 0 && std::abs(values[k]) > least)
      reached[static_cast<std::size_t>(e)] = true;
  return reached;
}

/// Returns the number of elements that are in one set but not in the other.
inline int count_unshared(const std::vector<bool>& a, const std::vector<bool>& b) {
  int count = 0;
  for (std::size_t e = 0; e < a.size(); ++e) count += a[e] != b[e] ? 1 : 0;
  return count;
}

/// Returns the element that holds a particle's whole box; -1 if none does.
template <int D>
int element_of_box(const Subject<D>& s, std::size_t p) {
  const auto& grid = s.body().grid();
  int element = 0;
  for (int d = D - 1; d >= 0; --d) {
    const double left = (s.body().tiling().x[p][d] - s.body().tiling().width[p][d] / 2 - grid.lower[d]) / grid.h[d];
    const double right = left + s.body().tiling().width[p][d] / grid.h[d];
    const double cell = std::floor(left + 1e-9);
    if (right > cell + 1 + 1e-9) return -1;
    element = element * (grid.cells[d] + 1) + static_cast<int>(cell);
  }
  return element;
}

/// (vii) Returns the largest number of elements that lie in the influence domain of only one of two particles, where
/// the boxes of both lie in one element.
template <int D>
double unshared_influence(const Subject<D>& s) {
  std::vector<std::vector<bool>> reached;
  for (Eigen::Index p = 0; p < s.phi().rows(); ++p) reached.push_back(elements_reached<D>(s, s.phi().row(p)));
  int worst = 0;
  for (std::size_t p = 0; p < reached.size(); ++p)
    for (std::size_t q = p + 1; q < reached.size(); ++q)
      if (const int element = element_of_box(s, p); element >= 0 && element == element_of_box(s, q))
        worst = std::max(worst, count_unshared(reached[p], reached[q]));
  return worst;
}

/// (vii) Returns the largest number of elements in which the influence domain of a particle and the union of the
/// supports of its nodes, those with v_ip > 0, differ.
template <int D>
double influence_beyond_support(const Subject<D>& s) {
  const Eigen::MatrixXd weighed = (s.body().v().array() > 1e-12).template cast<double>().matrix();
  const Eigen::MatrixXd supports = weighed.transpose() * s.N();
  int worst = 0;
  for (Eigen::Index p = 0; p < s.phi().rows(); ++p)
    worst = std::max(worst,
                     count_unshared(elements_reached<D>(s, s.phi().row(p)), elements_reached<D>(s, supports.row(p))));
  return worst;
}

/// Returns how far a function rises again after its lowest value along a line that starts near its maximum. A rise
/// above the first value does not count.
inline double valley_of(const std::vector<double>& values) {
  double low = values.front(), valley = 0;
  for (const double value : values) {
    keep_smaller(low, value);
    keep_larger(valley, std::min(values.front(), value) - low);
  }
  return valley;
}

/// (ix) Returns the deepest valley of Φ_p on rays from its maximum along sixteen directions (in one dimension two),
/// over that maximum.
template <int D>
double valley(const Subject<D>& s) {
  constexpr int directions[][2] = {{1, 0}, {1, 1}, {0, 1}, {2, 1}, {1, 2}, {-1, 1}, {-2, 1}, {-1, 2}};
  double worst = 0;
  for (Eigen::Index p = 0; p < s.phi().rows(); ++p) {
    Eigen::Index peak = 0;
    s.phi().row(p).maxCoeff(&peak);
    for (const auto& direction : directions)
      for (const int sign : {-1, 1}) {
        if (D == 1 && direction[1] != 0) continue;
        std::vector<double> values;
        for (auto i = s.lattice().index(static_cast<std::size_t>(peak)); s.lattice().holds(i);) {
          values.push_back(s.phi()(p, s.lattice().number(i)));
          for (std::size_t d = 0; d < D; ++d) i[d] += sign * direction[d];
        }
        keep_larger(worst, valley_of(values) / values.front());
      }
  }
  return worst;
}

}  // namespace mpmvv::checks::mapping
