#pragma once
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <vector>

#include "studies/plan/admission.hpp"
#include "studies/plan/study_runner.hpp"
#include "studies/records/record.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

/// Gets records of cases: from memory, from the store, or by running them. A case runs once, unless two threads ask for
/// it at the same time. Cases run in parallel, the long ones first, as far as the machine's memory allows. Two kinds
/// run alone: those whose cost is measured, before all others, on one thread and taking turns; and big ones, on all
/// threads.
class CasePool {
 public:
  CasePool(store::Store& store, const RunnerOptions& options);

  /// Records in the order of the cases. Several threads may call it.
  std::vector<records::Record> get(const std::vector<cases::Case>& cases);

  RunnerCounts counts() const { return counts_; }

 private:
  bool known(const cases::Case& c);
  void run_all(std::vector<cases::Case> missing);
  void time_all(const std::vector<cases::Case>& cases);
  void run_one(const cases::Case& c, double work_of_all);
  void keep(const records::Record& record);

  store::Store& store_;
  RunnerOptions options_;
  store::Provenance provenance_;
  RunnerCounts counts_;
  Progress progress_;
  std::map<cases::Case, records::Record> records_;
  std::vector<records::Record> finished_;  ///< not kept yet
  bool keeping_ = false;                   ///< a thread is at the store, outside the mutex
  std::exception_ptr not_kept_;            ///< why the store did not take what has finished
  std::mutex mutex_;                       ///< of everything above
  std::condition_variable kept_;
  Admission admission_;  ///< also where several threads search limits at once
};

}  // namespace mpmvv::plan
