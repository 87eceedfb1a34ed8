#include "solver/array.hpp"
#include "tests/benchmark/measure.hpp"

namespace mpmvv {

namespace {

/// Numbers in the widest register that the program is compiled for.
#ifdef __AVX512F__
constexpr int lanes = 8;
#else
constexpr int lanes = 4;
#endif

/// Independent chains of multiply-adds that stay in registers: enough of them to hide the latency of each.
void multiply_add_peak(benchmark::State& state) {
  using Pack = double __attribute__((vector_size(lanes * sizeof(double))));
  constexpr int chains = 12, rounds = 10000;
  Pack x[chains], factor = Pack{} + 0.999, summand = Pack{} + 0.1;
  for (auto& chain : x) chain = summand;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(summand);
  for (auto _ : state) {
    for (int k = 0; k < rounds; ++k)
#pragma GCC unroll 12
      for (auto& chain : x) chain = chain * factor + summand;
    for (auto& chain : x) benchmark::DoNotOptimize(chain);
  }
  state.counters["multiply_adds"] = benchmark::Counter(
      1.0 * lanes * chains * rounds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// a = b + s c over arrays far larger than the caches (McCalpin's triad); the store's own read is counted.
void triad(benchmark::State& state) {
  constexpr std::size_t n = std::size_t{1} << 24;
  solver::Array<double> a(n, 0), b(n, 1), c(n, 2);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3 * c[i];
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] =
      benchmark::Counter(4.0 * sizeof(double) * static_cast<double>(n) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

}  // namespace

void add_machine_benchmarks() {
  add_benchmark("machine/multiply-adds", multiply_add_peak);
  add_benchmark("machine/multiply-adds", multiply_add_peak)->Threads(2)->UseRealTime();
  add_benchmark("machine/triad", triad);
}

}  // namespace mpmvv
