#include "tests/benchmark/least_work.hpp"

/// A micro-benchmark: 20 steps of a static block, in which no particle leaves its cell, with each basis in 1D, 2D and
/// 3D, without a body force. The report holds the studies' cases against it.
namespace mpmvv {

namespace {

using namespace solver;

template <int D>
void block(benchmark::State& state, std::string_view basis, int cells, int ppc) {
  constexpr int steps = 20;
  auto scene = waving_block<D>(basis, cells, ppc);
  scene.integrator = "cd";
  measure_steps(state, scene, 0.1 * scene.h / block_wave_speed, steps);
  count_least_work(state, D, scene.basis);
}

/// Open-knot bases have no ghost nodes for a periodic block.
bool is_periodic(std::string_view basis) {
  return !basis.ends_with("-open");
}

}  // namespace

void add_block_benchmarks() {
  for (const std::string_view basis : words<AnyBasis>()) {
    if (!is_periodic(basis)) continue;
    const auto add = [&](int D, int ppc, auto run) {
      add_benchmark("block/" + filling_text(D, ppc) + "/" + std::string(basis), run);
    };
    add(1, 4, [=](benchmark::State& s) { block<1>(s, basis, 4096, 4); });
    add(2, 2, [=](benchmark::State& s) { block<2>(s, basis, 64, 2); });
    add(2, 4, [=](benchmark::State& s) { block<2>(s, basis, 32, 4); });
    add(3, 2, [=](benchmark::State& s) { block<3>(s, basis, 16, 2); });
    add(3, 4, [=](benchmark::State& s) { block<3>(s, basis, 10, 4); });
  }
}

}  // namespace mpmvv
