#include "tests/benchmark/measure.hpp"

/// What two threads make of a step: the same block on one and on two.
namespace mpmvv {

namespace {

using namespace solver;

template <int D>
void add_block(const char* what, int cells, int ppc) {
  for (const auto& [word, threads] : {std::pair{"one", 1}, {"two", 2}})
    add_benchmark(std::string("threads/") + what + "/" + word, [=](benchmark::State& state) {
      auto scene = waving_block<D>("bspline2", cells, ppc);
      scene.integrator = "cd";
      scene.threads = threads;
      measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, 10);
    })->UseRealTime();
}

}  // namespace

void add_thread_benchmarks() {
  add_block<2>("2D, 64 cells, 16 per cell", 64, 4);
  add_block<2>("2D, 128 cells, 4 per cell", 128, 2);
  add_block<3>("3D, 32 cells, 8 per cell", 32, 2);
}

}  // namespace mpmvv
