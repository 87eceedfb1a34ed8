#include <fmt/format.h>

#include <algorithm>

#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/cases.hpp"

namespace mpmvv::checks::mapping {

namespace {

/// The particle basis of B Fig. 16.5, with Dirac weights and the lumped mass: a line of particles, three to a cell (on
/// average, if placed at random), moved by `shift` cells from their `placement`.
class ShiftedLine {
 public:
  ShiftedLine(Placement placement, double shift)
      : body_(BlockOfParticles<1>::grid(), BlockOfParticles<1>::tiling(placement).translated(solver::Vec<1>(shift)),
              dirac),
        basis_(body_.basis(MassKind::lumped)) {}

  double x(std::size_t p) const { return body_.tiling().x[p][0]; }
  double width(std::size_t p) const { return body_.tiling().width[p][0]; }

  /// Returns Φ_p(x_p + s) for each offset s.
  std::vector<double> shape(std::size_t p, const std::vector<double>& offsets) const {
    Points<1> at;
    for (const double s : offsets) at.emplace_back(x(p) + s);
    const Eigen::RowVectorXd phi = basis_.at(body_.field().weights(at)).row(static_cast<Eigen::Index>(p));
    return {phi.begin(), phi.end()};
  }

  /// Returns ∫Φ_p dx / V_p.
  double integral(std::size_t p) const { return basis_.psi().col(static_cast<Eigen::Index>(p)).sum() / width(p); }

 private:
  MappedBody<1> body_;
  ParticleBasis basis_;
};

constexpr std::size_t middle_particle = 18, end_particle = 0;

/// Adds the curves of B Fig. 16.5: the basis function of one particle at seven places in its cell, and the hat between
/// its neighbours.
void add_shapes(CheckResult& result) {
  const auto offsets = linspace(-2, 2, 480);
  const auto unshifted = ShiftedLine(Placement::uniform, 0).shape(middle_particle, offsets);
  double change = 0, peak = 0;
  for (const double sixths : {0, 1, 2, 3, 4, 5, 6}) {
    const auto shape = ShiftedLine(Placement::uniform, sixths / 6).shape(middle_particle, offsets);
    result.add_curve(fmt::format("moved by {}/6 cells", sixths), offsets, shape);
    for (std::size_t k = 0; k < shape.size(); ++k) {
      keep_larger(change, std::abs(shape[k] - unshifted[k]));
      keep_larger(peak, unshifted[k]);
    }
  }
  std::vector<double> hat;
  for (const double s : offsets) hat.push_back(std::max(0.0, 1 - 3 * std::abs(s)));
  result.add_curve("point-to-point interpolation", offsets, hat);
  result.add("shape_change", change / peak, "largest change of the shape over its peak, translation over a cell");
}

void add_integrals(CheckResult& result) {
  struct Line {
    const char *name, *meaning;
    Placement placement;
    std::size_t particle;
  };
  for (const Line& line : {Line{"middle", "in the middle of equal particles", Placement::uniform, middle_particle},
                           Line{"end", "at the end of equal particles", Placement::uniform, end_particle},
                           Line{"random", "among particles of random sizes", Placement::random, middle_particle}}) {
    const auto shifts = linspace(0, 1, 120);
    std::vector<double> integrals;
    for (const double shift : shifts) integrals.push_back(ShiftedLine(line.placement, shift).integral(line.particle));
    const auto [least, largest] = std::ranges::minmax(integrals);
    result.add_curve(line.meaning, shifts, integrals);
    result.add(fmt::format("integral_variation_{}", line.name), largest - least,
               fmt::format("variation of the integral over V_p, a particle {}, translation over a cell", line.meaning));
  }
}

using Corner = solver::Vec<2>;

/// Adds the outline of a rectangle as a curve. It has so many points that it is drawn without markers.
void add_outline(CheckResult& result, const std::string& name, const Corner& lower, const Corner& upper) {
  constexpr int steps = 15;
  const Corner corners[] = {lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}, lower};
  std::vector<double> x, y;
  for (int side = 0; side < 4; ++side)
    for (int k = side == 0 ? 0 : 1; k <= steps; ++k) {
      const Corner at = corners[side] + (corners[side + 1] - corners[side]) * k / steps;
      x.push_back(at[0]), y.push_back(at[1]);
    }
  result.add_curve(name, x, y);
}

/// The particles of a two-dimensional picture: their boxes and, from the values of Φ_p, their influence domains.
class Picture {
 public:
  explicit Picture(const Weighting& weighting)
      : body_({{0, 0}, {1, 1}, {cells, cells}}, random_tiling<2>({4, 4}, {4, 4}, {8, 8}, 162), weighting),
        phi_(body_.basis(MassKind::lumped).at(weights_in_elements())) {}

  const Points<2>& particles() const { return body_.tiling().x; }

  std::size_t particle_near(const Corner& place) const {
    const auto distance = [&place](const Corner& x) { return (x - place).norm(); };
    return static_cast<std::size_t>(std::ranges::min_element(particles(), {}, distance) - particles().begin());
  }

  std::pair<Corner, Corner> box(std::size_t p) const {
    const Corner half = body_.tiling().width[p] / 2;
    return {particles()[p] - half, particles()[p] + half};
  }

  /// Returns the lower and upper corner of the rectangle that the elements with Φ_p ≠ 0 fill. It is a rectangle because
  /// the nodal functions are products.
  std::pair<Corner, Corner> influence(std::size_t p) const {
    Corner lower{cells, cells}, upper{0, 0};
    for (int e = 0; e < cells * cells; ++e) {
      const Corner element = element_corner(e);
      if (std::abs(phi_(static_cast<Eigen::Index>(p), e)) < 1e-12) continue;
      lower = lower.cwiseMin(element).eval(), upper = upper.cwiseMax(element + Corner(1, 1)).eval();
    }
    return {lower, upper};
  }

 private:
  static constexpr int cells = 12;

  static Corner element_corner(int e) { return {e % cells, e / cells}; }

  /// Returns the nodal functions at one point inside each element.
  Eigen::SparseMatrix<double> weights_in_elements() const {
    Points<2> points;
    for (int e = 0; e < cells * cells; ++e) points.emplace_back(element_corner(e) + Corner(0.37, 0.41));
    return body_.field().weights(points);
  }

  MappedBody<2> body_;
  Eigen::MatrixXd phi_;
};

/// Adds the outline of a rectangle, drawn `inset` cells inside its sides so that rectangles with common sides stay
/// apart.
void add_rectangle(CheckResult& result, const std::string& name, const std::pair<Corner, Corner>& corners,
                   double inset = 0) {
  const Corner step(inset, inset);
  add_outline(result, name, corners.first + step, corners.second - step);
}

void add_points(CheckResult& result, const std::string& name, const Points<2>& points) {
  std::vector<double> x, y;
  for (const Corner& at : points) x.push_back(at[0]), y.push_back(at[1]);
  result.add_curve(name, x, y);
}

/// Adds the physical and influence domains of B Figs. 16.2 to 16.4.
void add_domains(CheckResult& result) {
  const Picture with_boxes(gimp), with_points(dirac);
  int number = 0;
  Points<2> chosen;
  for (const Corner& place : {Corner(5.4, 5.6), Corner(6.7, 5.4), Corner(6.4, 6.6)}) {
    const std::size_t p = with_boxes.particle_near(place);
    chosen.push_back(with_boxes.particles()[p]);
    add_rectangle(result, fmt::format("physical domain {}", ++number), with_boxes.box(p));
    add_rectangle(result, fmt::format("influence domain {}", number), with_boxes.influence(p), 0.05 * number);
  }
  add_points(result, "particles", chosen);

  const std::size_t across = with_boxes.particle_near({6.05, 5.95});
  add_rectangle(result, "GIMP: physical domain", with_boxes.box(across));
  add_rectangle(result, "GIMP: influence domain", with_boxes.influence(across), 0.05);
  add_points(result, "Dirac: particle", {with_points.particles()[across]});
  add_rectangle(result, "Dirac: influence domain", with_points.influence(across), 0.1);

  const std::size_t a = with_boxes.particle_near({5.4, 5.4}), b = with_boxes.particle_near({6.6, 6.4});
  const auto [lower_a, upper_a] = with_boxes.influence(a);
  const auto [lower_b, upper_b] = with_boxes.influence(b);
  add_rectangle(result, "physical domain a", with_boxes.box(a));
  add_rectangle(result, "physical domain b", with_boxes.box(b));
  add_rectangle(result, "influence domain a", {lower_a, upper_a}, 0.05);
  add_rectangle(result, "influence domain b", {lower_b, upper_b}, 0.1);
  add_rectangle(result, "their overlap", {lower_a.cwiseMax(lower_b), upper_a.cwiseMin(upper_b)}, 0.15);
}

}  // namespace

}  // namespace mpmvv::checks::mapping

namespace mpmvv::checks {

/// Measures claim B-fig16.5, and adds the curves of B Figs. 16.2 to 16.4.
CheckResult check_mapping_figures() {
  CheckResult result;
  mapping::add_shapes(result);
  mapping::add_integrals(result);
  mapping::add_domains(result);
  return result;
}

}  // namespace mpmvv::checks
