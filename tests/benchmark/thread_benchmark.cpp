#include "tests/benchmark/studied_case.hpp"

/// What two threads make of a step: the same case on one, by the processor's time, and on two, by the clock.
namespace mpmvv {

void add_thread_benchmarks() {
  const std::string scheme = " basis=bspline2 integrator=cd cfl=0.4 ";
  for (const auto& [what, settings] :
       {std::pair{"square, 64 cells, 16 per cell", "problem=square boundary=symmetry cells=64 ppc=4"},
        std::pair{"square, 96 cells, 4 per cell", "problem=square boundary=symmetry cells=96 ppc=2"},
        std::pair{"cube, 24 cells, 8 per cell", "problem=cube boundary=periodic cells=24 ppc=2"}})
    for (const auto& [word, threads] : {std::pair{"one", 1}, {"two", 2}})
      add_benchmark(std::string("threads/") + what + "/" + word,
                    [c = case_of(settings + scheme), threads = threads](benchmark::State& state) {
                      measure_case(state, c, Seconds::clock, threads);
                    });
}

}  // namespace mpmvv
