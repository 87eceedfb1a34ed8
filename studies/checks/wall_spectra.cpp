#include <limits>
#include <utility>
#include <vector>

#include "solver/mpm.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/spectrum.hpp"

namespace mpmvv::checks {

namespace {

using solver::WallMethod;

/// A wall at rest.
struct Standing final : solver::WallMotion {
  double x;
  explicit Standing(double place) : x(place) {}
  double position(double) const override { return x; }
  double velocity(double) const override { return 0; }
  double gradient(double) const override { return 0; }
};

/// A bar of 8 cells with two particles each, without stress, between walls at rest. Its ends lie `offset` cells to the
/// right of nodes.
class ForceFreeBar {
 public:
  ForceFreeBar(const solver::AnyBasis& basis, double offset, double depth) : left_(4 + offset), right_(12 + offset) {
    constexpr int count = 16;
    scene_.cells = {16};
    scene_.basis = basis;
    scene_.material = solver::NeoHookeanSquare{0, 0};
    scene_.boundary = {solver::Wall{&left_, depth}, solver::Wall{&right_, depth}};
    auto& particles = scene_.particles;
    particles.resize(count);
    for (std::size_t p = 0; p < count; ++p) particles.x[p][0] = left_.x + (static_cast<double>(p) + 0.5) / 2;
    particles.F.assign(count, solver::Mat<1>::Identity());
    particles.m.assign(count, 0.5);
    particles.V0.assign(count, 0.5);
    particles.R.assign(count, solver::Mat<1>(0.5));
    particles.R0 = particles.R;
  }

  /// Returns the matrix that takes V to V' in one step. Its column q comes from a step of the solver in which particle
  /// q alone moves, at velocity one.
  Eigen::MatrixXd map(WallMethod method, int order) {
    scene_.velocity_update = solver::Fmpm{order};
    scene_.wall_method = method;
    const std::size_t n = scene_.particles.size();
    Eigen::MatrixXd map(n, n);
    for (std::size_t q = 0; q < n; ++q) {
      scene_.particles.v.assign(n, solver::Vec<1>::Zero());
      scene_.particles.v[q][0] = 1;
      solver::Mpm<1> mpm(scene_);
      mpm.step(1e-9);
      for (std::size_t p = 0; p < n; ++p)
        map(mpm.particles().id[p], static_cast<Eigen::Index>(q)) = mpm.particles().v[p][0];
    }
    return map;
  }

 private:
  Standing left_, right_;
  solver::Scene<1> scene_;
};

/// Returns the largest spectral radius over five places of the walls in their cells.
double largest_radius(const solver::AnyBasis& basis, double depth, WallMethod method, int order) {
  double largest = 0;
  for (const double offset : {0.0, 0.2, 0.4, 0.6, 0.8})
    keep_larger(largest, mapping::spectral_radius(ForceFreeBar(basis, offset, depth).map(method, order)));
  return largest;
}

struct BarBetweenWalls {
  const char *name, *title;
  solver::AnyBasis basis;
  double depth;
};

}  // namespace

/// Measures the spectral radius of a step of FMPM without forces between walls at rest, as a map from particle
/// velocities to particle velocities. Let C be the diagonal matrix that is zero on the held nodes and one elsewhere.
/// With Q = C S⁺S C and E = Σ_{l<k} (I - S⁺S)^l the radius is that of these matrices on the nodes:
///   C (I - (I - S⁺S)^k) C   velocity and lumped,   C E C Q   combined,   I - (I - Q)^k   elimination.
/// In the inner product weighted by the masses, S⁺S is symmetric with eigenvalues in [0, 1], and so is Q. The
/// eigenvalues of all methods but the combined one therefore lie in [0, 1] for every k. The combined method has those
/// of 2Q - Q² for k = 2, and for larger k they have no such bound.
CheckResult check_wall_spectra() {
  CheckResult result;
  const std::vector<BarBetweenWalls> settings{{"cpdi_d1", "CPDI, d = 1", solver::Cpdi{}, 1},
                                              {"cpdi_d2.5", "CPDI, d = 2.5", solver::Cpdi{}, 2.5},
                                              {"b2cpdi_d1.5", "B2CPDI, d = 1.5", solver::B2Cpdi{}, 1.5}};
  const std::vector<std::pair<const char*, WallMethod>> methods{{"velocity", WallMethod::velocity},
                                                                {"lumped", WallMethod::lumped},
                                                                {"combined", WallMethod::combined},
                                                                {"elimination", WallMethod::elimination}};
  const std::vector<double> orders{1, 2, 3, 4, 5, 6, 7, 8, 12, 16};
  for (const BarBetweenWalls& at : settings)
    for (const auto& [name, method] : methods) {
      std::vector<double> radii;
      double largest = 0, of_two = 0, least = std::numeric_limits<double>::infinity();
      for (const double k : orders) {
        radii.push_back(largest_radius(at.basis, at.depth, method, static_cast<int>(k)));
        keep_larger(largest, radii.back());
        k < 3 ? keep_larger(of_two, radii.back()) : keep_smaller(least, radii.back());
      }
      result.add_curve(std::string(name) + ", " + at.title, orders, radii);
      const std::string label = std::string(name) + "_" + at.name;
      result.add("largest_" + label, largest, "largest radius, k to 16");
      if (method != WallMethod::combined) continue;
      result.add("two_" + label, of_two, "largest radius, k = 1 and 2");
      result.add("least_" + label, least, "least radius, k from 3 to 16");
    }
  ForceFreeBar bar(solver::Cpdi{}, 0.4, 1);
  result.add("same_at_2", (bar.map(WallMethod::combined, 2) - bar.map(WallMethod::elimination, 2)).norm(),
             "combined against elimination, k = 2");
  return result;
}

}  // namespace mpmvv::checks
