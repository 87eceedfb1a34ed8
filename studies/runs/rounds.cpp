#include "studies/runs/rounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

namespace mpmvv::runs {

using cases::Case;
using records::Record;
using records::Status;

namespace {

/// An id that no other session has, here or on another machine: its end in µs since 1970, and a random number.
std::string new_session() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  std::random_device random;
  return fmt::format("{}-{:08x}{:08x}", std::chrono::duration_cast<std::chrono::microseconds>(since_1970).count(),
                     random(), random());
}

/// Sets the cost of a record to the geometric mean of `costs`, in ns per particle and step; does nothing without any.
void set_cost(Record& record, const std::vector<double>& costs, const std::string& session) {
  if (costs.empty()) return;
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  record.ns_per_particle_step = fits::geometric_mean(costs);
  record.cost.step_seconds = 1e-9 * record.ns_per_particle_step * static_cast<double>(record.particles * record.steps);
  record.cost.spread = (*most - *least) / record.ns_per_particle_step;
  record.cost.rounds = {costs, session};
}

}  // namespace

std::vector<Record> time_in_rounds(std::vector<Record> records, const std::function<Record(const Case&)>& run_again) {
  std::vector<std::vector<double>> costs(records.size());
  std::vector<std::size_t> turns(records.size());
  std::iota(turns.begin(), turns.end(), 0);
  bool due = true;
  for (int round = 0; due; ++round) {
    due = false;
    for (const std::size_t k : turns) {
      const Case& c = records[k].the_case;
      if (records[k].status != Status::ok || round >= c.measure.repeat) continue;
      due = true;
      const Record now = run_again(c);
      costs[k].push_back(now.ns_per_particle_step);
      if (now.status == Status::ok) continue;
      records[k] = now;
      costs[k].clear();
    }
    std::ranges::reverse(turns);
  }
  const std::string session = new_session();
  for (std::size_t k = 0; k < records.size(); ++k) set_cost(records[k], costs[k], session);
  return records;
}

}  // namespace mpmvv::runs
