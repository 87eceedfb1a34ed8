#include <cmath>

#include "mms/bar.hpp"
#include "tests/benchmark/measure.hpp"

/// The cost of a step per particle, on one thread, for every basis in 1D, 2D and 3D. Beside the time stand the
/// multiply-adds and the bytes that the method cannot do without.
namespace mpmvv {

namespace {

using namespace solver;

/// Of USL and CD per particle and step: at each of the s^D nodes the weight and its gradient (products of axes' values:
/// D - 1 and D (D - 1)), mass and momentum to the grid (1 + D), force (D²), velocity and acceleration back (2 D),
/// velocity gradient (D²); then F (D³), τ (D³), V⁰τ (D²), positions and velocities (2 D). The axes' own polynomials,
/// the logarithm and the grid are left out. The corners of a domain reach more nodes than s^D, or those several times.
double least_multiply_adds(int D, int support) {
  const double at_node = (D - 1) + D * (D - 1) + (1 + D) + D * D + 2 * D + D * D;
  return at_node * std::pow(support, D) + 2 * D * D * D + D * D + 2 * D;
}

/// x, v and F read and written once, mass, reference volume and identity read; the grid is shared by many particles.
/// Widths and edges that follow F are written and their reference read; others are read.
double least_bytes(int D, ParticleWidth width) {
  const std::array<int, 4> widths_of{0, D, 2 * D, 2 * D * D};
  const double widths = widths_of[static_cast<std::size_t>(width)];
  return sizeof(double) * (2 * (2 * D + D * D) + 2 + widths) + sizeof(std::uint32_t);
}

template <int D>
void block(benchmark::State& state, std::string_view basis, int cells, int ppc) {
  constexpr int steps = 20;
  auto scene = waving_block<D>(basis, cells, ppc);
  scene.integrator = "cd";
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps);
  const int support = std::visit([]<class B>(const B&) { return B::support; }, scene.basis);
  state.counters["least_multiply_adds"] = least_multiply_adds(D, support);
  state.counters["least_bytes"] = least_bytes(D, width_of(scene.basis));
}

class BarForce final : public BodyForce<1> {
 public:
  explicit BarForce(const mms::PointwiseSolution<1>& points) : points_(points) {}
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<1>> X, Vec<1>* b) const override {
    points_.body_force(t, ids, X, b);
  }
  Vec<1> at_position(const Vec<1>&, double) const override { return Vec<1>::Zero(); }

 private:
  const mms::PointwiseSolution<1>& points_;
};

/// S §5.2 with 4 particles per cell at a CFL number of 0.2, with its body force.
void bar(benchmark::State& state, std::string_view basis, int cells) {
  const double E = 1e4, C = 100;
  const mms::Bar solution(0.05, {E, 0, 1});
  Scene<1> scene = full_scene<1>(basis_named(basis), cells, 4);
  auto& particles = scene.particles;
  const auto X = particles.x;
  for (std::size_t p = 0; p < X.size(); ++p) {
    particles.x[p] += solution.u(X[p], 0);
    particles.F[p] = solution.F(X[p], 0);
  }
  const auto points = solution.at_points(X);
  BarForce force(*points);
  scene.body_force = &force;
  scene.material = NeoHookeanLog{0, E / 2};
  scene.integrator = "cd";
  scene.half_start = true;
  measure_steps(state, scene, 0.2 * scene.h / C, 200);
}

/// Open-knot bases have no ghost nodes for a periodic block.
bool is_periodic(std::string_view basis) {
  return !basis.ends_with("-open");
}

}  // namespace

void add_step_benchmarks() {
  for (const char* basis : {"bspline2", "linear", "bspline3", "ugimp", "cpgimp"})
    add_benchmark(std::string("step/bar with its body force, 512 cells, 4 per cell/") + basis,
                  [=](benchmark::State& s) { bar(s, basis, 512); });
  for (const std::string_view basis : words<AnyBasis>()) {
    if (!is_periodic(basis)) continue;
    const auto add = [&](const char* what, auto run) {
      add_benchmark(std::string("step/") + what + "/" + std::string(basis), run);
    };
    add("1D, 4 per cell", [=](benchmark::State& s) { block<1>(s, basis, 4096, 4); });
    add("2D, 4 per cell", [=](benchmark::State& s) { block<2>(s, basis, 64, 2); });
    add("2D, 16 per cell", [=](benchmark::State& s) { block<2>(s, basis, 32, 4); });
    add("3D, 8 per cell", [=](benchmark::State& s) { block<3>(s, basis, 16, 2); });
    add("3D, 64 per cell", [=](benchmark::State& s) { block<3>(s, basis, 10, 4); });
  }
}

}  // namespace mpmvv
