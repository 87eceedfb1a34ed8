#include <cmath>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/matrix_product.hpp"
#include "studies/checks/mapping/nodal_basis.hpp"
#include "studies/checks/mapping/particle_basis.hpp"
#include "studies/checks/mapping/particle_tiling.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// The matrices of N §2.1 and §2.2 for particles of random sizes and masses, which fill a block inside a wider grid.
/// Their velocities have no pattern.
class MassMatrices {
 public:
  Matrix S, round_trip;  ///< S, S⁺S
  Vector M, m, V, p;     ///< particle and lumped masses, particle velocities, momenta SᵀMV

  explicit MassMatrices(const mapping::GridBasis& basis) {
    const auto tiling = mapping::random_tiling<2>(Vec(2, 2), Vec(5, 4), {16, 12}, 5);
    const mapping::OverlayGrid<2> grid{Vec::Zero(), Vec::Ones(), {9, 8}};
    S = Matrix(mapping::NodalBasis<2>(basis, grid).weights(tiling.x, tiling.width)).transpose();
    M = tiling.masses();
    const Vector masses = S.transpose() * M;
    std::vector<int> reached;
    for (int n = 0; n < masses.size(); ++n)
      if (masses[n] > 0) reached.push_back(n);
    S = Matrix(S(Eigen::all, reached));
    m = masses(reached);
    V = Vector::NullaryExpr(M.size(), [](Eigen::Index k) { return std::sin(7.0 * static_cast<double>(k * k)); });
    p = S.transpose() * M.cwiseProduct(V);
    round_trip = m.cwiseInverse().asDiagonal() * mapping::matrix_product(S.transpose() * M.asDiagonal(), S);
  }

  Vector lumped() const { return p.cwiseQuotient(m); }

  /// Returns m̃_k⁻¹ p by N's recursion, started from k m⁻¹p.
  Vector binomial(int order) const { return alternating(order, order); }

  /// Returns Σ_l (-1)^(l+1) v*_l by N's recursion for v*_l from v*_1 = `start` m⁻¹p. A start of k gives m̃_k⁻¹ p; N
  /// prints 1.
  Vector alternating(int order, double start) const {
    Vector term = start * lumped(), sum = term;
    for (int l = 2; l <= order; ++l) {
      term = (order + 1.0 - l) / l * (round_trip * term);
      sum += l % 2 == 1 ? term : Vector(-term);
    }
    return sum;
  }

  /// Returns m̃_k⁻¹ p by N (1), Σ_l (-1)^(l+1) C(k, l) (S⁺S)^(l-1) m⁻¹p, with the powers as matrices.
  Vector by_powers(int order) const {
    Vector sum = Vector::Zero(m.size());
    Matrix power = Matrix::Identity(m.size(), m.size());
    double coefficient = 1;
    for (int l = 1; l <= order; ++l) {
      coefficient *= (order + 1.0 - l) / l;
      sum += (l % 2 == 1 ? coefficient : -coefficient) * (power * lumped());
      power = mapping::matrix_product(power, round_trip);
    }
    return sum;
  }

  Vector horner(int order) const {
    Vector w = lumped();
    for (int term = 1; term < order; ++term) w += lumped() - round_trip * w;
    return w;
  }

  Vector exact() const {
    return mapping::nodal_values(mapping::matrix_product(S.transpose() * M.asDiagonal(), S), S.transpose(), M, V);
  }

 private:
  using Vec = solver::Vec<2>;
};

double difference(const Vector& a, const Vector& b) {
  return (a - b).norm() / b.norm();
}

void add_inverse(const MassMatrices& s, CheckResult& result) {
  double binomial = 0, horner = 0, printed = 0;
  for (int k = 2; k <= 16; ++k) {
    keep_larger(binomial, difference(s.binomial(k), s.by_powers(k)));
    keep_larger(horner, difference(s.horner(k), s.by_powers(k)));
    keep_larger(printed, difference(s.alternating(k, 1) * k, s.by_powers(k)));
  }
  result.add("recursion", binomial, "recursion for v*_l from k m⁻¹p against (1), k to 16, relative");
  result.add("horner", horner, "Horner form against (1), k to 16, relative");
  result.add("printed_start", difference(s.alternating(8, 1), s.by_powers(8)),
             "recursion from m⁻¹p, as printed, against (1), k = 8, relative");
  result.add("printed_start_times_k", printed, "k times that against (1), k to 16, relative");
}

/// Adds the distance of the expansion from the exact solve for k up to 512. The series converges where S⁺S has no
/// eigenvalue near zero. Distances are taken in the norm of the consistent mass m̃ = SᵀMS, sqrt(vᵀ m̃ v).
void add_limit(const MassMatrices& s, const char* name, CheckResult& result) {
  const Vector exact = s.exact();
  const auto distance = [&](const Vector& v) {
    const Vector on_particles = s.S * (v - exact);
    return std::sqrt(s.M.dot(on_particles.cwiseAbs2())) / std::sqrt(s.M.dot((s.S * exact).cwiseAbs2()));
  };
  std::vector<double> orders, distances;
  double largest_growth = 0;
  for (int k = 1; k <= 512; k *= 2) {
    orders.push_back(k);
    distances.push_back(distance(s.horner(k)));
    if (k > 1) keep_larger(largest_growth, distances.back() / distances[distances.size() - 2]);
  }
  result.add_curve(name, orders, distances);
  result.add(std::string("growth_") + name, largest_growth,
             "largest ratio of the distance at 2k to that at k, k to 256");
  result.add(std::string("distance_") + name, distances.back(), "distance from the exact solve at k = 512, relative");
}

/// Compares P_X V, where P_X = I - (I - SS⁺)^k, with S m̃_k⁻¹ SᵀM V.
void add_projection(const MassMatrices& s, CheckResult& result) {
  double largest = 0;
  for (const int k : {1, 2, 4, 8, 16}) {
    Vector rest = s.V;
    for (int l = 0; l < k; ++l) {
      const Vector momentum = s.S.transpose() * s.M.cwiseProduct(rest);
      rest -= s.S * momentum.cwiseQuotient(s.m);
    }
    keep_larger(largest, difference(s.V - rest, s.S * s.horner(k)));
  }
  result.add("projection", largest, "P_X V against S m̃_k⁻¹SᵀM V, k to 16, relative");
}

/// The first step of the bar with one velocity update. It starts from velocities without a pattern, which are the same
/// for all updates.
struct Step {
  Vector V, V_new, rate;  ///< V, V', (X' - X)/Δt

  explicit Step(const std::vector<settings::Setting>& update) {
    std::vector<settings::Setting> settings{
        {"problem", "bar", ""}, {"basis", "bspline2", ""}, {"integrator", "usl", ""}, {"boundary", "periodic", ""},
        {"cells", "16", ""},    {"ppc", "3", ""},          {"cfl", "0.2", ""}};
    settings.insert(settings.end(), update.begin(), update.end());
    const cases::Case c = settings::make_case(settings);
    runs::PreparedCase<1> prepared = runs::prepare_case<1>(c, problems::find_problem("bar", ""), 1);
    auto& velocities = prepared.scene.particles.v;  // the bar of the problem starts at rest
    for (std::size_t p = 0; p < velocities.size(); ++p)
      velocities[p][0] = 5 * std::sin(7.0 * static_cast<double>(p * p));
    solver::Mpm<1> mpm(std::move(prepared.scene));
    V = field(mpm.particles().v);
    const Vector X = field(mpm.particles().x);
    mpm.step(c.resolution.dt);
    V_new = field(mpm.particles().v);
    rate = (field(mpm.particles().x) - X) / c.resolution.dt;
  }

  Vector effective_velocity() const { return rate - (V_new - V) / 2; }

 private:
  static Vector field(const solver::Array<solver::Vec<1>>& values) {
    return Eigen::Map<const Vector>(values.front().data(), static_cast<Eigen::Index>(values.size()));
  }
};

}  // namespace

/// Measures claims N-inverse and N-equal on matrices.
CheckResult check_full_mass_inverse() {
  CheckResult result;
  const MassMatrices splines(solver::BSpline2{}), boxes(solver::Gimp{});
  add_inverse(splines, result);
  add_limit(splines, "splines", result);
  add_limit(boxes, "gimp", result);
  add_projection(splines, result);
  return result;
}

/// Compares V' of MPM-PIC, XPIC(1) and FMPM(1) with each other. Compares their effective velocities, 𝕍 = (X' - X)/Δt -
/// (V' - V)/2, with N (2).
CheckResult check_pic_updates() {
  CheckResult result;
  const Step pic({{"velocity_update", "pic", ""}});
  const Step xpic({{"velocity_update", "xpic", ""}, {"order", "1", ""}});
  const Step fmpm({{"velocity_update", "fmpm", ""}, {"order", "1", ""}});
  const Step flip({{"velocity_update", "flip", ""}, {"position", "second-order", ""}});
  const Vector mapped = flip.effective_velocity();  // S m⁻¹p, N §2.3
  double acceleration = difference(xpic.V_new, pic.V_new), apart = difference(mapped, fmpm.V);
  keep_larger(acceleration, difference(fmpm.V_new, pic.V_new));
  keep_smaller(apart, difference((pic.V + pic.V_new) / 2, mapped));
  result.add("acceleration", acceleration, "V' of XPIC(1) and FMPM(1) against MPM-PIC's, relative");
  result.add("fmpm", difference(fmpm.effective_velocity(), fmpm.V), "effective velocity of FMPM(1) against V");
  result.add("xpic", difference(xpic.effective_velocity(), mapped), "effective velocity of XPIC(1) against S m⁻¹p");
  result.add("pic", difference(pic.effective_velocity(), (pic.V + pic.V_new) / 2),
             "effective velocity of MPM-PIC against (V + V')/2");
  result.add("apart", apart, "how far the three effective velocities lie apart at least, relative");
  return result;
}

}  // namespace mpmvv::checks
