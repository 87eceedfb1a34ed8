#include "studies/plan/case_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "studies/codes/external_run.hpp"
#include "studies/plan/estimates.hpp"
#include "studies/plan/work.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/runs/run_part.hpp"
#include "studies/settings/part.hpp"
#include "studies/support/memory.hpp"
#include "studies/support/not_measured.hpp"
#include "studies/support/parallel.hpp"

namespace mpmvv::plan {

using cases::Case;
using records::Record;

namespace {

/// Four fifths of the memory that programs can have now.
double usable_memory() {
  return 0.8 * support::available_memory();
}

std::string label(const Case& c) {
  const auto [basis, integrator, velocity_update] = cases::method_of(c.scheme);
  return fmt::format("{} {} {} {} cells={} ppc={}", c.problem.name, basis, integrator, c.scheme.boundary,
                     c.resolution.cells, c.resolution.ppc);
}

}  // namespace

CasePool::CasePool(store::Store& store, const RunnerOptions& options)
    : store_(store),
      options_(options),
      provenance_(store::current_provenance()),
      costs_(&store),
      admission_(options.jobs, usable_memory()),
      on_stop_(options.stop, [this] {
        if (!options_.on_stop) return;
        with_store([this] {
          counts_.unkept = finished_.size();
          options_.on_stop(counts_);
        });
      }) {
  store_.wait_with([this](double seconds) { return waits_on(seconds); });
}

std::vector<Record> CasePool::get(const std::vector<Case>& cases) {
  run_all(missing(cases));
  run_all(missing(cases));  // what was timed before, where a case that had failed is sound now
  std::unique_lock lock(mutex_);
  kept_.wait(lock, [this] { return !is_writing_; });
  if (write_error_) std::rethrow_exception(write_error_);
  std::vector<Record> records;
  for (const Case& c : cases) records.push_back(records_.at(c));
  return records;
}

std::vector<Case> CasePool::missing(const std::vector<Case>& cases) {
  std::set<Case> missing;
  with_store([&] {
    for (const Case& c : cases)
      if (!load_known(c)) missing.insert(c);
    for (const Case& c : timed_apart(cases, [this](const Case& one) { return known(one); })) missing.insert(c);
    const std::size_t before = progress_.total;
    for (const Case& c : missing) {
      if (!asked_for_.insert(c).second) continue;
      remaining_.add(c, costs_.time(c).seconds);
      ++progress_.total;
    }
    if (progress_.total > before) report_to(options_.more_work);
  });
  return {missing.begin(), missing.end()};
}

double CasePool::seconds(const std::vector<Case>& cases) {
  double sum = 0;
  with_store([&] {
    for (const Case& c : cases)
      if (!load_known(c)) sum += costs_.time(c).seconds;
  });
  return sum;
}

std::optional<Record> CasePool::known(const Case& c) const {
  const auto record = records_.find(c);
  return record == records_.end() ? store_.find(c, provenance_.digest) : record->second;
}

bool CasePool::load_known(const Case& c) {
  if (records_.contains(c)) return true;
  const auto stored = store_.find(c, provenance_.digest);
  if (!stored || (options_.retries && records::is_worth_another_try(*stored))) return false;
  records_.emplace(c, *stored);
  from_store_.insert(c);
  counts_.reused = from_store_.size();
  return true;
}

void CasePool::run_all(std::vector<Case> missing) {
  const auto timed =
      std::stable_partition(missing.begin(), missing.end(), [](const Case& c) { return c.measure.repeat == 0; });
  if (timed != missing.end()) time_all(longest_first({timed, missing.end()}));
  missing.erase(timed, missing.end());
  missing = longest_first(missing);
  const double all = seconds(missing);
  support::for_each_parallel(missing.size(), options_.jobs, [&](std::size_t k) { run(missing[k], all); });
}

std::vector<Case> CasePool::longest_first(const std::vector<Case>& cases) {
  std::vector<std::pair<double, Case>> with_seconds;
  with_store([&] {
    for (const Case& c : cases) with_seconds.emplace_back(costs_.time(c).seconds, c);
  });
  std::ranges::stable_sort(with_seconds, std::greater{}, &std::pair<double, Case>::first);
  std::vector<Case> sorted;
  for (auto& [time, c] : with_seconds) sorted.push_back(std::move(c));
  return sorted;
}

void CasePool::expect(double seconds) {
  const std::lock_guard lock(mutex_);
  remaining_.expect(seconds);
}

/// Notes how many threads have shared a case, and so what it took on one core.
Record CasePool::finish(Record record, int threads) {
  record.threads = threads;
  const int runs = 1 + record.the_case.measure.repeat;
  const std::lock_guard lock(mutex_);
  remaining_.finish(record.the_case, runs * threads * record.wall_seconds);
  return record;
}

void CasePool::report_to(const std::function<void(const Progress&)>& listener) {
  if (!listener) return;
  progress_.seconds_left = remaining_.seconds(options_.jobs);
  listener(progress_);
}

/// Runs each case once, beside others, and then measures costs. Nothing else runs and nothing is written during that
/// time.
void CasePool::time_all(const std::vector<Case>& cases) {
  std::vector<Record> records(cases.size());
  support::for_each_parallel(cases.size(), options_.jobs, [&](std::size_t k) {
    const Admission::Place place(admission_, 1, memory_estimate(cases[k]));
    records[k] = codes::run_untimed(cases[k], options_.codes);
  });
  double memory = 0;
  for (const Case& c : cases) memory = std::max(memory, memory_estimate(c));
  {
    const Admission::Place place(admission_, options_.jobs, memory);
    records = codes::time_in_rounds(std::move(records), options_.codes);
  }
  for (Record& record : records) record = finish(record, 1);
  keep(std::move(records));
}

void CasePool::run(const Case& c, double seconds_of_all) {
  if (!is_done(c)) keep({record_of(c, seconds_of_all)});
}

/// Whether the case has become known since it was found missing: a thread has run it, or another program has kept it.
bool CasePool::is_done(const Case& c) {
  const std::lock_guard lock(mutex_);
  if (!records_.contains(c)) return false;
  if (asked_for_.erase(c) > 0) {
    remaining_.finish(c, support::not_measured);
    progress_.label = label(c);
    ++progress_.done;
    report_to(options_.progress);
  }
  return true;
}

Record CasePool::record_of(const Case& c, double seconds_of_all) {
  if (!c.scheme.code.empty()) return external_record_of(c);
  if (const auto part = settings::part_of(c)) {
    const int images = solver::count(part->images);
    const double memory = memory_estimate(part->body, images);
    const int threads = threads_for(c, images, memory, seconds_of_all);
    const Admission::Place place(admission_, threads, memory);
    if (const auto record = runs::run_part(c, *part, threads)) return finish(*record, threads);
  }
  const double memory = memory_estimate(c);
  const int threads = threads_for(c, 1, memory, seconds_of_all);
  const Admission::Place place(admission_, threads, memory);
  return finish(runs::run_case(c, threads), threads);
}

/// Another code takes one thread.
Record CasePool::external_record_of(const Case& c) {
  const Admission::Place place(admission_, 1, memory_estimate(c));
  return finish(codes::run_external(c, options_.codes.at(c.scheme.code)), 1);
}

/// All threads for a case that takes much memory, or that would still run when all others are done, if they can share
/// it; else one.
int CasePool::threads_for(const Case& c, int images, double memory, double seconds_of_all) {
  constexpr double much_memory = 1024.0 * 1024 * 1024;
  const bool takes_much = memory > much_memory || outlasts_others(seconds({c}), seconds_of_all, options_.jobs);
  return takes_much && can_be_shared(c, images) ? options_.jobs : 1;
}

/// Whether to wait on for another process that locks the store. To merge a large store or to vacuum it takes minutes; a
/// process that locks it for an hour hangs. The thread that asks is the one that uses the store.
bool CasePool::waits_on(double seconds) {
  constexpr double long_time = 2, too_long = 3600;
  if (options_.stop.stop_requested()) return false;
  if (seconds < long_time)
    has_told_of_wait_ = false;
  else if (!std::exchange(has_told_of_wait_, true) && options_.on_wait)
    options_.on_wait();
  has_given_up_ |= seconds > too_long;
  return !has_given_up_;
}

/// One thread at a time writes to the store, all that has finished in one transaction; the others go on running. Where
/// it cannot, one that finishes later tries again.
void CasePool::keep(std::vector<Record> records) {
  std::unique_lock lock(mutex_);
  std::ranges::move(records, std::back_inserter(finished_));
  if (is_writing_) return;
  is_writing_ = true;
  while (!finished_.empty()) {
    const std::vector<Record> batch = std::exchange(finished_, {});
    lock.unlock();
    try {
      store_.keep(batch, store::with_present_time(provenance_));
    } catch (...) {
      lock.lock();
      finished_.insert(finished_.begin(), batch.begin(), batch.end());
      write_error_ = std::current_exception();
      is_writing_ = false;
      kept_.notify_all();
      throw;
    }
    lock.lock();
    for (const Record& kept : batch) {
      records_.insert_or_assign(kept.the_case, kept);
      // Another program may have kept the case while it ran here; it then counts as run, not as taken from the store.
      from_store_.erase(kept.the_case);
      counts_.reused = from_store_.size();
      ++counts_.ran;
      progress_.done += asked_for_.erase(kept.the_case);
      progress_.label = label(kept.the_case);
      report_to(options_.progress);
    }
  }
  is_writing_ = false;
  kept_.notify_all();
}

}  // namespace mpmvv::plan
