#include "studies/store/provenance.hpp"
#include "tests/benchmark/measure.hpp"

/// What a step costs in the studies' cases and in a block, what scenes skip, and what the machine can do. The digest in
/// the answer says which program it was, so that a report shows no other's.
int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::AddCustomContext("digest", mpmvv::store::current_provenance().digest);
  mpmvv::add_machine_benchmarks();
  mpmvv::add_case_benchmarks();
  mpmvv::add_block_benchmarks();
  mpmvv::add_skip_benchmarks();
  mpmvv::add_thread_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
}
