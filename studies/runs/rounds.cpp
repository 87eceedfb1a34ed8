#include "studies/runs/rounds.hpp"

#include <algorithm>

#include "studies/fits/median.hpp"

namespace mpmvv::runs {

using cases::Case;
using records::Record;
using records::Status;

namespace {

/// Sets the cost of a record to the median of `costs`, in ns per particle and step; does nothing without any.
void set_cost(Record& record, const std::vector<double>& costs) {
  if (costs.empty()) return;
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  record.ns_per_particle_step = fits::median_of(costs);
  record.cost.step_seconds = 1e-9 * record.ns_per_particle_step * static_cast<double>(record.particles * record.steps);
  record.cost.spread = (*most - *least) / record.ns_per_particle_step;
}

}  // namespace

std::vector<Record> run_in_rounds(const std::vector<Case>& cases, const std::function<Record(const Case&)>& run,
                                  const std::function<Record(const Case&)>& run_again) {
  std::vector<Record> records;
  for (const Case& c : cases) records.push_back(run(c));
  std::vector<std::vector<double>> costs(cases.size());
  bool due = true;
  for (int round = 0; due; ++round) {
    due = false;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      if (records[k].status != Status::ok || round >= cases[k].measure.repeat) continue;
      due = true;
      const Record now = round > 0 ? run_again(cases[k]) : records[k];
      costs[k].push_back(now.ns_per_particle_step);
      if (now.status == Status::ok) continue;
      records[k] = now;
      costs[k].clear();
    }
  }
  for (std::size_t k = 0; k < cases.size(); ++k) set_cost(records[k], costs[k]);
  return records;
}

}  // namespace mpmvv::runs
