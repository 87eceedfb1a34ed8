#pragma once
#include <string>
#include <vector>

#include "reports/benchmark.hpp"
#include "reports/table.hpp"

namespace mpmvv::reports {

/// What a step costs in another code, as someone published or measured it.
struct PublishedCost {
  std::string on;  ///< one thread, all cores, ...
  std::string name, what, precision, hardware;
  std::string published;  ///< the number as it stands in the source
  double seconds, steps, particles;
  std::string beside;  ///< the case of this program to compare with: dimension and particles per cell, basis
  std::string source, date;

  double per_particle_step() const { return seconds / (steps * particles); }  ///< s
};

/// The costs of reports/published_costs.toml.
const std::vector<PublishedCost>& published_costs();

/// The same from text; `name` stands for the file in messages. Throws UsageError where a field is missing, unknown or
/// of another type.
std::vector<PublishedCost> read_published_costs(const std::string& text, const std::string& name);

/// Their times beside those of this program's cases; empty without such a case.
Table others_table(const Benchmark& benchmark, const std::vector<PublishedCost>& codes);

}  // namespace mpmvv::reports
