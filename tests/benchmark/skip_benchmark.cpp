#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>

#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/store/store.hpp"
#include "tests/benchmark/measure.hpp"

/// What a scene does not need and therefore does not pay: each row is run with it (`paid`) and without (`skipped`).
namespace mpmvv {

using cases::Case;
using records::Record;
using records::Status;
using runs::run_case;
using settings::make_case;
using settings::Setting;
using store::current_provenance;
using store::Provenance;
using store::Store;

namespace {

using namespace solver;

constexpr int steps_measured = 20;

void compare(const std::string& name, const std::string& meaning, const std::function<void(benchmark::State&)>& paid,
             const std::function<void(benchmark::State&)>& skipped) {
  for (const auto& [side, run] : {std::pair{"paid", paid}, std::pair{"skipped", skipped}})
    add_benchmark("skip/" + name + "/" + side, [meaning, run = run](benchmark::State& state) {
      run(state);
      state.SetLabel(meaning);
    });
}

template <int D>
void logarithm(benchmark::State& state, double lambda) {
  auto scene = waving_block<D>("bspline2", D == 2 ? 64 : 16, 2);
  scene.material = NeoHookeanLog{lambda, 4000};
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps_measured);
}

/// A solution's body force at the particles' reference positions.
template <int D>
class SolutionForce : public BodyForce<D> {
 public:
  Vec<D> at_position(const Vec<D>&, double) const override { return Vec<D>::Zero(); }
};

/// Evaluated anew in every step: sines and cosines for each particle.
template <int D>
class AnewForce final : public SolutionForce<D> {
 public:
  AnewForce(const mms::ManufacturedSolution<D>& solution, const std::vector<Vec<D>>& X) : solution_(solution), X_(X) {}
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    for (std::size_t k = 0; k < ids.size(); ++k) b[k] = solution_.b(X_[ids[k]], t);
  }

 private:
  const mms::ManufacturedSolution<D>& solution_;
  std::vector<Vec<D>> X_;
};

/// From parts that are computed once.
template <int D>
class OnceForce final : public SolutionForce<D> {
 public:
  OnceForce(const mms::ManufacturedSolution<D>& solution, const std::vector<Vec<D>>& X)
      : points_(solution.at_points(X)) {}
  void prepare(double t) override { points_->prepare(t); }
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>> X, Vec<D>* b) const override {
    points_->body_force(t, ids, X, b);
  }

 private:
  std::unique_ptr<mms::PointwiseSolution<D>> points_;
};

template <int D, class Force>
void body_force(benchmark::State& state, const mms::ManufacturedSolution<D>& solution, Scene<D> scene) {
  Force force(solution, scene.particles.x);
  scene.body_force = &force;
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps_measured);
}

template <class Force>
void bar_force(benchmark::State& state) {
  auto scene = full_scene<1>(basis_named("bspline2"), 4096, 4);
  scene.material = NeoHookeanLog{0, 5000};
  body_force<1, Force>(state, mms::Bar(0.05, {1e4, 0, 1}), scene);
}

template <class Force>
void cube_force(benchmark::State& state) {
  body_force<3, Force>(state, mms::Cube(0.05, {1e4, 0.3, 1}), full_scene<3>(basis_named("bspline2"), 16, 2));
}

/// A ring of outer radius 1/2 that fills a third of its square grid, or the same number of particles on a grid that
/// they fill, about.
void grid_filled_by(benchmark::State& state, bool ring) {
  constexpr int cells = 128, fewer = 74;
  auto scene = full_scene<2>(basis_named("bspline2"), ring ? cells : fewer, 2, Free{});
  if (ring) {
    std::vector<Vec<2>> x;
    for (const auto& at : scene.particles.x) {
      const double r = (at - Vec<2>::Constant(0.5)).norm();
      if (r < 0.5 && r > 0.38) x.push_back(at);
    }
    scene.particles = particles_at<2>(x, std::pow(scene.h / 2, 2));
  }
  set_wave(scene, 0.01);
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps_measured);
}

/// Widths that a basis without widths takes no notice of, but that are kept up to date and sorted along.
void fields(benchmark::State& state, bool unused) {
  auto scene = waving_block<3>("bspline2", 16, 2);
  if (unused) scene.particles.l.assign(scene.particles.size(), Vec<3>::Constant(0.5));
  if (unused) scene.particles.l0 = scene.particles.l;
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps_measured);
}

using Words = std::vector<std::pair<std::string, std::string>>;

/// The bar of S §5.2 with these words beside its own.
Case bar_case(const Words& more) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : Words{{"problem", "bar"}, {"basis", "bspline2"}, {"cells", "256"}, {"ppc", "4"}})
    settings.push_back({key, value, "the benchmark"});
  for (const auto& [key, value] : more) settings.push_back({key, value, "the benchmark"});
  return make_case(settings);
}

/// A whole case, by the steps that it was to take.
void whole_case(benchmark::State& state, const Words& words, Status expected) {
  const Case c = bar_case(words);
  for (auto _ : state) {
    const Record record = run_case(c, 1);
    if (record.status != expected) state.SkipWithError(("the case is " + to_string(record.status)).c_str());
  }
  count_particle_steps(state, 4.0 * c.resolution.cells * static_cast<double>(c.resolution.steps));
}

void cached_case(benchmark::State& state) {
  const Case c = bar_case({{"cfl", "0.4"}});
  const auto file = std::filesystem::temp_directory_path() / ("mpmvv_benchmark_" + std::to_string(getpid()) + ".db");
  {
    Store store(file, Store::Mode::create_or_write);
    const Provenance provenance = current_provenance();
    store.keep(run_case(c, 1), provenance);
    for (auto _ : state)
      if (!store.find(c, provenance.digest)) state.SkipWithError("the case is not in the store");
  }
  std::filesystem::remove(file);
  count_particle_steps(state, 4.0 * c.resolution.cells * static_cast<double>(c.resolution.steps));
}

}  // namespace

void add_skip_benchmarks() {
  using State = benchmark::State;
  constexpr double tiny = 1e-12;  // moves nothing, but takes the logarithm
  compare(
      "logarithm, 2D", "no logarithm at λ = 0 (2D block, bspline2)", [](State& s) { logarithm<2>(s, tiny); },
      [](State& s) { logarithm<2>(s, 0); });
  compare(
      "logarithm, 3D", "no logarithm at λ = 0 (3D block, bspline2)", [](State& s) { logarithm<3>(s, tiny); },
      [](State& s) { logarithm<3>(s, 0); });
  compare("body force, 1D", "spatial part of the body force once (bar, bspline2)", bar_force<AnewForce<1>>,
          bar_force<OnceForce<1>>);
  compare("body force, 3D", "spatial part of the body force once (cube, bspline2)", cube_force<AnewForce<3>>,
          cube_force<OnceForce<3>>);
  compare(
      "active cells", "only active cells (2D ring that fills a third of its grid, against a full square)",
      [](State& s) { grid_filled_by(s, true); }, [](State& s) { grid_filled_by(s, false); });
  compare(
      "fields", "no unused particle fields (3D block, bspline2, with cpGIMP's widths and without)",
      [](State& s) { fields(s, true); }, [](State& s) { fields(s, false); });
  compare(
      "errors", "no errors over all steps unless asked (bar, whole case)",
      [](State& s) {
        whole_case(s, {{"cfl", "0.4"}, {"every_step", "true"}}, Status::ok);
      },
      [](State& s) {
        whole_case(s, {{"cfl", "0.4"}}, Status::ok);
      });
  // 2560 steps: at CFL 1.6 they blow up, at CFL 0.1 they do not.
  compare(
      "early end", "an unstable run ends when it has blown up (bar at CFL 1.6, against as many stable steps)",
      [](State& s) {
        whole_case(s, {{"cfl", "0.1"}, {"steps", "2560"}}, Status::ok);
      },
      [](State& s) {
        whole_case(s, {{"cfl", "1.6"}, {"end_time", "0.16"}}, Status::unstable);
      });
  compare(
      "cached case", "a case that is in the store is not run again (bar)",
      [](State& s) {
        whole_case(s, {{"cfl", "0.4"}}, Status::ok);
      },
      cached_case);
}

}  // namespace mpmvv
