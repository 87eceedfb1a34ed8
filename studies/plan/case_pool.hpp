#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
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

/// Gets records of cases: from memory, from the store, or by running them; only a part of the body is run where its
/// images make up the rest. A case runs once, unless two threads ask for it at the same time. Cases run in parallel,
/// the long ones first, as far as the machine's memory allows. Big ones run alone, on all threads. Those whose cost
/// is measured are then timed alone, on one thread and taking turns.
class CasePool {
 public:
  CasePool(store::Store& store, const RunnerOptions& options);
  ~CasePool() { store_.wait_with({}); }
  CasePool(const CasePool&) = delete;
  CasePool& operator=(const CasePool&) = delete;

  /// Records in the order of the cases. Several threads may call it.
  std::vector<records::Record> get(const std::vector<cases::Case>& cases);

  /// The cases whose records are neither in memory nor in the store, each once, and those that must be timed anew.
  std::vector<cases::Case> missing(const std::vector<cases::Case>& cases);

  /// Runs a case whose cost is not measured. It is one of several that take `seconds_of_all` together; this decides how
  /// many threads it gets.
  void run(const cases::Case& c, double seconds_of_all);

  /// Estimated seconds, one case after the other on one core, for the cases that are neither in memory nor in the
  /// store.
  double seconds(const std::vector<cases::Case>& cases);

  /// Announces work of so many seconds whose cases are not known yet; a negative number takes it back once they are.
  void expect(double seconds);

  /// Reserves one thread for work that is not a case.
  Admission::Place place() { return {admission_, 1, 0}; }

  /// Calls `act` while no thread of the pool uses the store.
  template <class Act>
  void with_store(const Act& act) {
    std::unique_lock lock(mutex_);
    kept_.wait(lock, [this] { return !is_writing_; });
    act();
  }

  RunnerCounts counts() const { return counts_; }

 private:
  std::optional<records::Record> known(const cases::Case& c) const;
  bool load_known(const cases::Case& c);
  void run_all(std::vector<cases::Case> missing);
  std::vector<cases::Case> longest_first(const std::vector<cases::Case>& cases);
  bool is_done(const cases::Case& c);
  records::Record record_of(const cases::Case& c, double seconds_of_all);
  records::Record external_record_of(const cases::Case& c);
  records::Record finish(records::Record record, int threads);
  void report_to(const std::function<void(const Progress&)>& listener);
  int threads_for(const cases::Case& c, int images, double memory, double seconds_of_all);
  void time_all(const std::vector<cases::Case>& cases);
  void keep(std::vector<records::Record> records);
  bool waits_on(double seconds);

  store::Store& store_;
  RunnerOptions options_;
  store::Provenance provenance_;
  CostModel costs_;
  RunnerCounts counts_;
  Progress progress_;
  Remaining remaining_;
  std::set<cases::Case> asked_for_;  ///< and not known yet; each counts once, whoever else asks for it
  std::map<cases::Case, records::Record> records_;
  std::set<cases::Case> from_store_;       ///< those of them that come from the store and were not run
  std::vector<records::Record> finished_;  ///< not kept yet
  bool is_writing_ = false;                ///< a thread is writing to the store without holding the mutex
  std::exception_ptr write_error_;         ///< why writing to the store failed
  std::mutex mutex_;                       ///< guards everything above
  std::condition_variable kept_;
  bool has_told_of_wait_ = false, has_given_up_ = false;  ///< for the thread that waits for a locked store
  Admission admission_;  ///< one for all threads, also when several search limits at once
  std::stop_callback<std::function<void()>> on_stop_;
};

}  // namespace mpmvv::plan
