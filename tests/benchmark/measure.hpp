#pragma once
#include <benchmark/benchmark.h>

#include <string>

#include "tests/solver/scenes.hpp"

namespace mpmvv {

/// Under this name the report reads the time per particle and step, in seconds.
inline constexpr const char* per_particle_step = "per_particle_step";

inline void count_particle_steps(benchmark::State& state, double particle_steps_per_iteration) {
  state.counters[per_particle_step] =
      benchmark::Counter(particle_steps_per_iteration * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Advances copies of a scene, each from its start, so that the motion measured is always the same.
template <int D>
void measure_steps(benchmark::State& state, const solver::Scene<D>& scene, double dt, int steps) {
  for (auto _ : state) {
    state.PauseTiming();
    {
      solver::Mpm<D> mpm(scene);
      state.ResumeTiming();
      mpm.advance(dt, steps);
      state.PauseTiming();
      if (!mpm.fault().empty()) state.SkipWithError(mpm.fault().c_str());
    }
    state.ResumeTiming();
  }
  count_particle_steps(state, static_cast<double>(scene.particles.size()) * steps);
}

/// A periodic block of unit size with a smooth velocity, and a time step of a tenth of the wave's way through a cell.
template <int D>
solver::Scene<D> waving_block(std::string_view basis, int cells, int ppc) {
  auto scene = solver::full_scene<D>(solver::basis_named(basis), cells, ppc);
  solver::set_wave(scene, 1);
  scene.least_in_slab = solver::Scene<D>().least_in_slab;
  return scene;
}

inline constexpr double block_wave_speed = 120;

/// "3D, 64 per cell", of four particles per cell and direction.
inline std::string filling_text(int D, int ppc) {
  int particles = 1;
  for (int d = 0; d < D; ++d) particles *= ppc;
  return std::to_string(D) + "D, " + std::to_string(particles) + " per cell";
}

/// Names a benchmark at run time, for rows that a loop makes.
template <class Run>
benchmark::internal::Benchmark* add_benchmark(const std::string& name, const Run& run) {
  return benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

void add_machine_benchmarks();
void add_block_benchmarks();
void add_case_benchmarks();
void add_skip_benchmarks();
void add_thread_benchmarks();

}  // namespace mpmvv
