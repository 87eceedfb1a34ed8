#include "studies/store/provenance.hpp"
#include "tests/benchmark/measure.hpp"

/// The cost of a step, what scenes skip, and what the machine can do. The digest in the answer says which program it
/// was, so that a report shows no other's.
int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::AddCustomContext("digest", mpmvv::store::current_provenance().digest);
  mpmvv::add_machine_benchmarks();
  mpmvv::add_step_benchmarks();
  mpmvv::add_skip_benchmarks();
  mpmvv::add_thread_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
}
