#include "studies/plan/case_pool.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "studies/plan/estimates.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/support/parallel.hpp"

namespace mpmvv::plan {

using cases::Case;
using records::Record;

namespace {

/// Four fifths of the memory that is free now.
double usable_memory() {
  return 0.8 * static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Whether the case takes all threads for itself: it fills the memory, or would still run when all others are done.
bool is_big(const Case& c, double work_of_all, int jobs) {
  constexpr double much_memory = 1024.0 * 1024 * 1024, much_work = 1e8;
  const double work = work_estimate(c);
  return memory_estimate(c) > much_memory || (work > much_work && work * jobs > work_of_all);
}

std::string label(const Case& c) {
  return fmt::format("{} {} {} {} cells={} ppc={}", c.problem.name, c.scheme.basis, c.scheme.integrator,
                     c.scheme.boundary, c.resolution.cells, c.resolution.ppc);
}

}  // namespace

CasePool::CasePool(store::Store& store, const RunnerOptions& options)
    : store_(store),
      options_(options),
      provenance_(store::current_provenance()),
      admission_(options.jobs, usable_memory()) {}

std::vector<Record> CasePool::get(const std::vector<Case>& cases) {
  std::vector<Case> missing;
  {
    std::unique_lock lock(mutex_);
    kept_.wait(lock, [this] { return !keeping_; });
    for (const Case& c : cases)
      if (!known(c)) missing.push_back(c);
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    progress_.total += missing.size();
  }
  run_all(std::move(missing));
  std::unique_lock lock(mutex_);
  kept_.wait(lock, [this] { return !keeping_; });
  if (not_kept_) std::rethrow_exception(not_kept_);
  std::vector<Record> records;
  for (const Case& c : cases) records.push_back(records_.at(c));
  return records;
}

bool CasePool::known(const Case& c) {
  if (records_.contains(c)) return true;
  const auto stored = store_.find(c, provenance_.digest);
  if (!stored || records::is_worth_another_try(*stored)) return false;
  records_.emplace(c, *stored);
  ++counts_.reused;
  return true;
}

void CasePool::run_all(std::vector<Case> missing) {
  const auto timed =
      std::stable_partition(missing.begin(), missing.end(), [](const Case& c) { return c.measure.repeat == 0; });
  if (timed != missing.end()) time_all({timed, missing.end()});
  missing.erase(timed, missing.end());
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Case& a, const Case& b) { return work_estimate(a) > work_estimate(b); });
  double work_of_all = 0;
  for (const Case& c : missing) work_of_all += work_estimate(c);
  support::for_each_parallel(missing.size(), options_.jobs, [&](std::size_t k) { run_one(missing[k], work_of_all); });
}

/// Measures costs. Nothing else runs and nothing is written during that time.
void CasePool::time_all(const std::vector<Case>& cases) {
  double memory = 0;
  for (const Case& c : cases) memory = std::max(memory, memory_estimate(c));
  std::vector<Record> records;
  {
    const Admission::Place place(admission_, options_.jobs, memory);
    records = runs::run_timed(cases);
  }
  for (const Record& record : records) keep(record);
}

void CasePool::run_one(const Case& c, double work_of_all) {
  const int threads = is_big(c, work_of_all, options_.jobs) ? options_.jobs : 1;
  const Admission::Place place(admission_, threads, memory_estimate(c));
  keep(runs::run_case(c, threads));
}

/// One thread at a time writes to the store, all that has finished in one transaction; the others go on running.
void CasePool::keep(const Record& record) {
  std::unique_lock lock(mutex_);
  finished_.push_back(record);
  if (keeping_) return;
  keeping_ = true;
  while (!finished_.empty()) {
    const std::vector<Record> batch = std::exchange(finished_, {});
    lock.unlock();
    try {
      store_.keep(batch, provenance_);
    } catch (...) {
      lock.lock();
      not_kept_ = std::current_exception();
      keeping_ = false;
      kept_.notify_all();
      throw;
    }
    lock.lock();
    for (const Record& kept : batch) {
      records_.emplace(kept.the_case, kept);
      ++counts_.ran;
      ++progress_.done;
      progress_.label = label(kept.the_case);
      if (options_.progress) options_.progress(progress_);
    }
  }
  keeping_ = false;
  kept_.notify_all();
}

}  // namespace mpmvv::plan
