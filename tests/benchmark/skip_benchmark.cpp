#include <unistd.h>

#include <filesystem>
#include <functional>

#include "studies/problems/problem.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/store/store.hpp"
#include "tests/benchmark/studied_case.hpp"

/// What a scene does not need and therefore does not pay: each row is a case of the studies over its whole end time,
/// with it (`paid`) and without (`skipped`).
namespace mpmvv {

using cases::Case;
using records::Record;
using records::Status;
using runs::PreparedCase;
using store::Provenance;
using store::Store;

namespace {

using namespace solver;

/// Changes nothing.
constexpr auto as_it_is = [](auto&) {};

/// The steps of a case, whose scene `change` may alter before.
template <int D>
void steps_of(benchmark::State& state, const std::string& settings,
              const std::function<void(PreparedCase<D>&)>& change) {
  const Case c = case_of(settings);
  auto prepared = runs::prepare_case<D>(c, problems::find_problem(c.problem.name, "the benchmark"), 1);
  change(prepared);
  measure_steps(state, prepared.scene, c.resolution.dt, static_cast<int>(c.resolution.steps));
}

using Side = std::function<void(benchmark::State&)>;

void compare(const std::string& name, const std::string& meaning, const Side& paid, const Side& skipped) {
  for (const auto& [side, run] : {std::pair{"paid", paid}, std::pair{"skipped", skipped}})
    add_benchmark("skip/" + name + "/" + side, [meaning, run = run](benchmark::State& state) {
      run(state);
      state.SetLabel(meaning);
    });
}

/// A case's steps with what `add` puts into its scene, against its own.
template <int D>
void compare_steps(const std::string& name, const std::string& meaning, const std::string& settings,
                   const std::function<void(PreparedCase<D>&)>& add) {
  compare(
      name, meaning, [=](benchmark::State& state) { steps_of<D>(state, settings, add); },
      [=](benchmark::State& state) { steps_of<D>(state, settings, as_it_is); });
}

/// A λ that changes no result, but takes the logarithm.
template <int D>
void take_logarithm(PreparedCase<D>& prepared) {
  std::get<NeoHookeanLog>(prepared.scene.material).lambda = 1e-12;
}

/// A solution's body force evaluated anew in every step: sines and cosines for each particle.
template <int D>
class AnewForce final : public BodyForce<D> {
 public:
  explicit AnewForce(const PreparedCase<D>& prepared) : solution_(*prepared.setup.solution), X_(prepared.X) {}
  Vec<D> at_position(const Vec<D>&, double) const override { return Vec<D>::Zero(); }
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    for (std::size_t k = 0; k < ids.size(); ++k) b[k] = solution_.b(X_[ids[k]], t);
  }

 private:
  const mms::ManufacturedSolution<D>& solution_;
  std::vector<Vec<D>> X_;
};

template <int D>
void compare_body_forces(const std::string& name, const std::string& meaning, const std::string& settings) {
  const auto force = std::make_shared<std::optional<AnewForce<D>>>();
  compare_steps<D>(name, meaning, settings,
                   [force](PreparedCase<D>& prepared) { prepared.scene.body_force = &force->emplace(prepared); });
}

/// Empty cells as many again on either side along each axis.
void widen(PreparedCase<2>& prepared) {
  for (int d = 0; d < 2; ++d) {
    int& cells = prepared.scene.cells[static_cast<std::size_t>(d)];
    prepared.scene.lower[d] -= cells * prepared.scene.h;
    cells *= 3;
  }
}

/// Widths that a basis without widths takes no notice of, but that are kept up to date and sorted along.
void add_widths(PreparedCase<3>& prepared) {
  Particles<3>& particles = prepared.scene.particles;
  particles.l.assign(particles.size(), Vec<3>::Constant(0.5));
  particles.l0 = particles.l;
}

const std::string bar = "problem=bar basis=bspline2 cells=256 ppc=4 ";
const std::string moving = " basis=bspline2 integrator=cd cfl=0.4 ppc=2 ";

/// A whole case, by the steps that it was to take.
void whole_case(benchmark::State& state, const std::string& settings, Status expected) {
  const Case c = case_of(bar + settings);
  for (auto _ : state) {
    const Record record = runs::run_case(c, 1);
    if (record.status != expected) state.SkipWithError(("the case is " + to_string(record.status)).c_str());
  }
  count_particle_steps(state, 4.0 * c.resolution.cells * static_cast<double>(c.resolution.steps));
}

void cached_case(benchmark::State& state) {
  const Case c = case_of(bar + "cfl=0.4");
  const auto file = std::filesystem::temp_directory_path() / ("mpmvv_benchmark_" + std::to_string(getpid()) + ".db");
  {
    Store store(file, Store::Mode::create_or_write);
    const Provenance provenance = store::current_provenance();
    store.keep(runs::run_case(c, 1), provenance);
    for (auto _ : state)
      if (!store.find(c, provenance.digest)) state.SkipWithError("the case is not in the store");
  }
  std::filesystem::remove(file);
  count_particle_steps(state, 4.0 * c.resolution.cells * static_cast<double>(c.resolution.steps));
}

}  // namespace

void add_skip_benchmarks() {
  using State = benchmark::State;
  const std::string without_lambda = "param.poissons_ratio=0";
  compare_steps<2>("logarithm, 2D", "no logarithm at λ = 0 (square, bspline2)",
                   "problem=square boundary=symmetry cells=64" + moving + without_lambda, take_logarithm<2>);
  compare_steps<3>("logarithm, 3D", "no logarithm at λ = 0 (cube, bspline2)",
                   "problem=cube boundary=periodic cells=16" + moving + without_lambda, take_logarithm<3>);
  compare_body_forces<1>("body force, 1D", "spatial part of the body force once (bar, bspline2)",
                         "problem=bar boundary=periodic cells=512" + moving);
  compare_body_forces<3>("body force, 3D", "spatial part of the body force once (cube, bspline2)",
                         "problem=cube boundary=periodic cells=16" + moving);
  compare_steps<2>("empty cells",
                   "fewer empty cells (ring, bspline2: its own grid against one of nine times as many cells)",
                   "problem=ring cells=32" + moving, widen);
  compare_steps<3>("fields", "no unused particle fields (cube, bspline2, with cpGIMP's widths and without)",
                   "problem=cube boundary=periodic cells=16" + moving, add_widths);
  compare(
      "errors", "no errors over all steps unless asked (bar, whole case)",
      [](State& s) { whole_case(s, "cfl=0.4 every_step=true", Status::ok); },
      [](State& s) { whole_case(s, "cfl=0.4", Status::ok); });
  // 2560 steps: at CFL 1.6 they blow up, at CFL 0.1 they do not.
  compare(
      "early end", "an unstable run ends when it has blown up (bar at CFL 1.6, against as many stable steps)",
      [](State& s) { whole_case(s, "cfl=0.1 steps=2560", Status::ok); },
      [](State& s) { whole_case(s, "cfl=1.6 end_time=0.16", Status::unstable); });
  compare(
      "cached case", "a case that is in the store is not run again (bar)",
      [](State& s) { whole_case(s, "cfl=0.4", Status::ok); }, cached_case);
}

}  // namespace mpmvv
