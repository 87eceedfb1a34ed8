#pragma once
#include <sstream>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "tests/benchmark/measure.hpp"

namespace mpmvv {

/// The case that "key=value key=value ..." describes, in a study file's words.
inline cases::Case case_of(const std::string& settings) {
  std::vector<cases::Setting> list;
  std::istringstream words(settings);
  for (std::string word; words >> word;) {
    const auto sign = word.find('=');
    list.push_back({word.substr(0, sign), word.substr(sign + 1), "the benchmark"});
  }
  return settings::make_case(list);
}

/// Which seconds count: the processor's, after a first run; or those of a first run, of several threads by the clock.
enum class Seconds { processor, clock };

/// Runs the case to its end; what the record says of its steps is the time, set-up and norms apart.
inline records::Record measure_case(benchmark::State& state, cases::Case c, Seconds by, int threads = 1) {
  c.measure.repeat = by == Seconds::processor ? 1 : 0;
  records::Record record;
  double seconds = 0;
  for (auto _ : state) {
    record = runs::run_case(c, threads);
    seconds += 1e-9 * record.ns_per_particle_step;
    if (record.status != records::Status::ok)
      state.SkipWithError(("the case is " + to_string(record.status) + ": " + record.reason).c_str());
  }
  state.counters[per_particle_step] = benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
  return record;
}

}  // namespace mpmvv
