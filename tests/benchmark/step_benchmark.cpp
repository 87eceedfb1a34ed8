#include <benchmark/benchmark.h>

#include "mms/bar.hpp"
#include "tests/solver/scenes.hpp"

/// The cost of a step per particle, on one thread. The first line is the target case: the bar with its body force.
namespace mpmvv::solver {

namespace {

constexpr int steps = 100;

class BarForce final : public BodyForce<1> {
 public:
  explicit BarForce(const mms::PointwiseSolution<1>& points) : points_(points) {}
  void on_particles(double t, std::span<const std::uint32_t> ids, Vec<1>* b) const override {
    points_.body_force(t, ids, b);
  }
  Vec<1> at_position(const Vec<1>&, double) const override { return Vec<1>::Zero(); }

 private:
  const mms::PointwiseSolution<1>& points_;
};

/// Advances copies of a scene, each from its start, so that the motion measured is always the same.
template <int D>
void measure(benchmark::State& state, const Scene<D>& scene, double dt) {
  for (auto _ : state) {
    state.PauseTiming();
    {
      Mpm<D> mpm(scene);
      state.ResumeTiming();
      for (int k = 0; k < steps; ++k) mpm.step(dt);
      state.PauseTiming();
      if (!mpm.fault().empty()) state.SkipWithError(mpm.fault().c_str());
    }
    state.ResumeTiming();
  }
  const double particle_steps =
      static_cast<double>(scene.particles.size()) * steps * static_cast<double>(state.iterations());
  state.counters["per_particle_step"] =
      benchmark::Counter(particle_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// S §5.2 with 4 particles per cell at a CFL number of 0.2.
void bar(benchmark::State& state, std::string_view basis) {
  const int cells = static_cast<int>(state.range(0));
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
  const BarForce force(*points);
  scene.body_force = &force;
  scene.material = NeoHookeanLog{0, E / 2};
  scene.integrator = "cd";
  scene.half_start = true;
  measure(state, scene, 0.2 * scene.h / C);
}

/// A periodic block with a smooth velocity, no body force.
template <int D>
void block(benchmark::State& state, std::string_view basis) {
  Scene<D> scene =
      full_scene<D>(basis_named(basis), static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  set_wave(scene, 1);
  measure(state, scene, 0.1 * scene.h / 120);
}

void block_2d(benchmark::State& state, std::string_view basis) {
  block<2>(state, basis);
}
void block_3d(benchmark::State& state, std::string_view basis) {
  block<3>(state, basis);
}

BENCHMARK_CAPTURE(bar, bspline2, "bspline2")->Arg(512)->Arg(64)->Arg(8);
BENCHMARK_CAPTURE(bar, linear, "linear")->Arg(512);
BENCHMARK_CAPTURE(bar, bspline3, "bspline3")->Arg(512);
BENCHMARK_CAPTURE(bar, ugimp, "ugimp")->Arg(512);
BENCHMARK_CAPTURE(bar, cpgimp, "cpgimp")->Arg(512);
BENCHMARK_CAPTURE(block_2d, linear, "linear")->Args({64, 2});
BENCHMARK_CAPTURE(block_2d, bspline2, "bspline2")->Args({64, 2});
BENCHMARK_CAPTURE(block_2d, bspline2, "bspline2")->Args({32, 4});
BENCHMARK_CAPTURE(block_2d, cpgimp, "cpgimp")->Args({64, 2});
BENCHMARK_CAPTURE(block_3d, linear, "linear")->Args({16, 2});
BENCHMARK_CAPTURE(block_3d, bspline2, "bspline2")->Args({24, 2});
BENCHMARK_CAPTURE(block_3d, bspline2, "bspline2")->Args({12, 4});
BENCHMARK_CAPTURE(block_3d, cpgimp, "cpgimp")->Args({12, 4});

}  // namespace

}  // namespace mpmvv::solver

BENCHMARK_MAIN();
