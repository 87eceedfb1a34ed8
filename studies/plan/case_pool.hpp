#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <vector>

#include "studies/plan/admission.hpp"
#include "studies/plan/cost_model.hpp"
#include "studies/plan/study_runner.hpp"
#include "studies/records/record.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

/// Gets records of cases: from memory, from the store, or by running them, on a part of the body where images of it
/// make the rest. A case runs once, unless two threads ask for it at the same time. Cases run in parallel, the long
/// ones first, as far as the machine's memory allows. Two kinds run alone: those whose cost is measured, on one thread
/// and taking turns; and big ones, on all threads.
class CasePool {
 public:
  CasePool(store::Store& store, const RunnerOptions& options);

  /// Records in the order of the cases. Several threads may call it.
  std::vector<records::Record> get(const std::vector<cases::Case>& cases);

  /// Those of the cases whose records are neither in memory nor in the store, each once.
  std::vector<cases::Case> missing(const std::vector<cases::Case>& cases);

  /// Runs a case whose cost is not measured, one of several that take so many seconds in all.
  void run(const cases::Case& c, double seconds_of_all);

  /// How long those of the cases take that are neither in memory nor in the store, one after the other.
  double seconds(const std::vector<cases::Case>& cases);

  /// Work of so many seconds whose cases are not known yet, or (negative) are now.
  void expect(double seconds);

  /// A place of one thread among the cases that run, for something else.
  Admission::Place place() { return {admission_, 1, 0}; }

  /// Calls `act` while no thread of the pool is at the store.
  template <class Act>
  void with_store(const Act& act) {
    std::unique_lock lock(mutex_);
    kept_.wait(lock, [this] { return !keeping_; });
    act();
  }

  RunnerCounts counts() const { return counts_; }

 private:
  bool known(const cases::Case& c);
  void run_all(std::vector<cases::Case> missing);
  bool is_there(const cases::Case& c);
  records::Record record_of(const cases::Case& c, double seconds_of_all);
  records::Record external_record_of(const cases::Case& c);
  void finish(const cases::Case& c, double core_seconds);
  void report_to(const std::function<void(const Progress&)>& listener);
  int threads_for(double memory, double seconds, double seconds_of_all) const;
  void time_all(const std::vector<cases::Case>& cases);
  void keep(const records::Record& record);

  store::Store& store_;
  RunnerOptions options_;
  store::Provenance provenance_;
  CostModel costs_;
  RunnerCounts counts_;
  Progress progress_;
  Remaining remaining_;
  std::map<cases::Case, records::Record> records_;
  std::set<cases::Case> taken_;            ///< those of them that come from the store and were not run
  std::vector<records::Record> finished_;  ///< not kept yet
  bool keeping_ = false;                   ///< a thread is at the store, outside the mutex
  std::exception_ptr not_kept_;            ///< why the store did not take what has finished
  std::mutex mutex_;                       ///< of everything above
  std::condition_variable kept_;
  Admission admission_;  ///< also where several threads search limits at once
  std::stop_callback<std::function<void()>> on_stop_;
};

}  // namespace mpmvv::plan
