#include "studies/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "studies/error.hpp"
#include "studies/result.hpp"

namespace mpmvv {

namespace {

constexpr std::array status_words{"ok", "unstable", "failed"};
constexpr std::array verdict_words{"holds", "fails", "shown", "inconclusive"};

/// The enumerator whose word this is: the words stand in the order of the enumerators.
template <class Enum, std::size_t N>
Enum from_word(const std::array<const char*, N>& words, const std::string& word, const char* what) {
  const auto it = std::find(words.begin(), words.end(), word);
  if (it == words.end())
    throw UsageError(fmt::format("unknown {} '{}' (known: {})", what, word, fmt::join(words, ", ")));
  return static_cast<Enum>(it - words.begin());
}

}  // namespace

const std::vector<RunNumber>& run_errors() {
  static const std::vector<RunNumber> numbers{{"l1", [](auto& r) -> auto& {return r.error.l1;
}
}  // namespace mpmvv
, {"l2", [](auto& r) -> auto& {return r.error.l2;
}
}
, {"linf", [](auto& r) -> auto& {return r.error.linf;
}
}
, {"l1_all_steps", [](auto& r) -> auto& {return r.error.l1_all_steps;
}
}
, {"l2_all_steps", [](auto& r) -> auto& {return r.error.l2_all_steps;
}
}
, {"linf_all_steps", [](auto& r) -> auto& {return r.error.linf_all_steps;
}
}
, {"nodal_l1", [](auto& r) -> auto& {return r.error.nodal_l1;
}
}
, {"nodal_l2", [](auto& r) -> auto& {return r.error.nodal_l2;
}
}
, {"nodal_linf", [](auto& r) -> auto& {return r.error.nodal_linf;
}
}
, {"velocity_error", [](auto& r) -> auto& {return r.error.velocity;
}
}
, {"stress_error", [](auto& r) -> auto& {return r.error.stress;
}
}
, {"mass_change", [](auto& r) -> auto& {return r.balance.mass;
}
}
, {"momentum_change", [](auto& r) -> auto& {return r.balance.momentum;
}
}
, {
  "angular_momentum_change", [](auto& r) -> auto& {
    return r.balance.angular_momentum;
  }
}
}
;
return numbers;
}

const std::vector<RunNumber>& run_by_products() {
  static const std::vector<RunNumber> numbers{{"kinetic", [](auto& r) -> auto& {return r.energy.kinetic;
}
}
, {"strain", [](auto& r) -> auto& {return r.energy.strain;
}
}
, {"initial_total", [](auto& r) -> auto& {return r.energy.initial_total;
}
}
, {"wall_seconds", [](auto& r) -> auto& {return r.wall_seconds;
}
}
, {"ns_per_particle_step", [](auto& r) -> auto& {return r.ns_per_particle_step;
}
}
, {"step_seconds", [](auto& r) -> auto& {return r.cost.step_seconds;
}
}
, {"step_seconds_spread", [](auto& r) -> auto& {return r.cost.spread;
}
}
, {
  "cfl", [](auto& r) -> auto& {
    return r.cfl;
  }
}
}
;
return numbers;
}

const std::vector<std::string>& norm_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all{"energy_loss"};
    for (const RunNumber& number : run_errors()) all.emplace_back(number.name);
    return all;
  }();
  return words;
}

std::string to_string(Status s) {
  return status_words.at(static_cast<std::size_t>(s));
}

Status status_from(const std::string& word) {
  return from_word<Status>(status_words, word, "status");
}

std::string to_string(PartVerdict v) {
  return verdict_words.at(static_cast<std::size_t>(v));
}

PartVerdict part_verdict_from(const std::string& word) {
  return from_word<PartVerdict>(verdict_words, word, "verdict of a claim's part");
}

}  // namespace mpmvv
