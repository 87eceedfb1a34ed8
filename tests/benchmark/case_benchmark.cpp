#include <fmt/format.h>

#include "studies/problems/problem.hpp"
#include "tests/benchmark/least_work.hpp"
#include "tests/benchmark/studied_case.hpp"

/// What people run: cases of the studies over their whole end time, with their body force and their integrator, bodies
/// that move through cells.
namespace mpmvv {

namespace {

/// Seconds each: the sides of a comparison are a case and its block, which short cases do not bring closer.
constexpr int repetitions = 3;

struct StudiedCase {
  const char* what;
  const char* settings;
};

/// Cube as in s-fig12 and x-cost-cube, square as in x-cost-square, on its finest grid, but between planes of symmetry,
/// ring and shell as in x-cost-ring and x-cost-shell, vortex as in x-cost-vortex, impact as in n-cost but to its end,
/// bar as in x-cost.
constexpr StudiedCase studied_cases[] = {
    {"cube, 16 cells", "problem=cube basis=bspline2 integrator=cd boundary=periodic cells=16 ppc=4 cfl=0.4"},
    {"cube, 32 cells", "problem=cube basis=bspline2 integrator=cd boundary=periodic cells=32 ppc=2 cfl=0.4"},
    {"square, 96 cells", "problem=square basis=bspline2 integrator=cd boundary=symmetry cells=96 ppc=4 cfl=0.4"},
    {"square, 96 cells", "problem=square basis=bspline2 integrator=cd boundary=symmetry cells=96 ppc=2 cfl=0.4"},
    {"ring, 64 cells", "problem=ring quarter=true fill=conforming basis=cpgimp integrator=cd cells=64 ppc=2 cfl=0.4"},
    {"ring, 64 cells", "problem=ring quarter=true fill=conforming basis=bspline3 integrator=cd cells=64 ppc=2 cfl=0.4"},
    {"vortex, 48 cells", "problem=vortex fill=conforming basis=bspline3 integrator=cd cells=48 ppc=2 cfl=0.2"},
    {"shell, 16 cells",
     "problem=shell quarter=true fill=conforming basis=bspline3 integrator=cd cells=16 ppc=2 cfl=0.4"},
    {"shell, 16 cells", "problem=shell quarter=true fill=conforming basis=cpgimp integrator=cd cells=16 ppc=2 cfl=0.4"},
    {"shell, 16 cells", "problem=shell quarter=true fill=conforming basis=cpdi integrator=cd cells=16 ppc=2 cfl=0.4"},
    {"impact, FMPM(1)",
     "problem=impact deformation=exponential basis=cpdi integrator=usl velocity_update=fmpm order=1 cells=10 ppc=2 "
     "cfl=0.2"},
    {"impact, FMPM(4)",
     "problem=impact deformation=exponential basis=cpdi integrator=usl velocity_update=fmpm order=4 cells=10 ppc=2 "
     "cfl=0.2"},
    {"bar, 512 cells", "problem=bar basis=bspline2 integrator=cd boundary=periodic cells=512 ppc=4 cfl=0.4"},
    {"bar, 512 cells",
     "problem=bar basis=linear integrator=cd boundary=periodic cells=512 ppc=4 cfl=0.4 blowup_error=10"},
    {"bar, 512 cells", "problem=bar basis=bspline3 integrator=cd boundary=periodic cells=512 ppc=4 cfl=0.4"},
    {"bar, 512 cells", "problem=bar basis=cpgimp integrator=cd boundary=periodic cells=512 ppc=4 cfl=0.4"},
};

}  // namespace

/// The name says which block a case is held against.
void add_case_benchmarks() {
  for (const StudiedCase& studied : studied_cases) {
    const cases::Case c = case_of(studied.settings);
    const int D = problems::find_problem(c.problem.name, "the benchmark").dimension();
    const std::string block = filling_text(D, c.resolution.ppc) + "/" + c.scheme.basis;
    add_benchmark("case/" + block + "/" + studied.what, [=](benchmark::State& state) {
      const records::Record record = measure_case(state, c, Seconds::processor);
      state.counters["particles"] = static_cast<double>(record.particles);
      state.counters["steps"] = static_cast<double>(record.steps);
      count_least_work(state, D, solver::basis_named(c.scheme.basis), std::max(c.scheme.order - 1, 0));
    })->Repetitions(repetitions);
  }
}

}  // namespace mpmvv
