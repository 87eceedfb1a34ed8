#include "studies/records/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <new>
#include <system_error>

#include "studies/records/result.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::records {

namespace {

constexpr std::array status_words{"ok", "unstable", "failed"};
constexpr std::array failure_words{"none", "case", "machine"};
constexpr std::array verdict_words{"holds", "fails", "shown", "inconclusive"};

/// The enumerator whose word this is: the words stand in the order of the enumerators.
template <class Enum, std::size_t N>
Enum from_word(const std::array<const char*, N>& words, const std::string& word, const char* what) {
  const auto it = std::find(words.begin(), words.end(), word);
  if (it == words.end())
    throw support::UsageError(fmt::format("unknown {} '{}' (known: {})", what, word, fmt::join(words, ", ")));
  return static_cast<Enum>(it - words.begin());
}

/// The number that these members of members lead to.
template <auto... members>
RunNumber number(const char* name) {
  return {name, [](const Record& r) -> const double& { return (r.*....*members); },
          [](Record& r) -> double& { return (r.*....*members); }};
}

}  // namespace

const std::vector<RunNumber>& run_errors() {
  static const std::vector<RunNumber> numbers{
      number<&Record::error, &Errors::l1>("l1"),
      number<&Record::error, &Errors::l2>("l2"),
      number<&Record::error, &Errors::linf>("linf"),
      number<&Record::error, &Errors::l1_all_steps>("l1_all_steps"),
      number<&Record::error, &Errors::l2_all_steps>("l2_all_steps"),
      number<&Record::error, &Errors::linf_all_steps>("linf_all_steps"),
      number<&Record::error, &Errors::nodal_l1>("nodal_l1"),
      number<&Record::error, &Errors::nodal_l2>("nodal_l2"),
      number<&Record::error, &Errors::nodal_linf>("nodal_linf"),
      number<&Record::error, &Errors::velocity>("velocity_error"),
      number<&Record::error, &Errors::stress>("stress_error"),
      number<&Record::balance, &Balance::mass>("mass_change"),
      number<&Record::balance, &Balance::momentum>("momentum_change"),
      number<&Record::balance, &Balance::angular_momentum>("angular_momentum_change")};
  return numbers;
}

const std::vector<RunNumber>& run_by_products() {
  static const std::vector<RunNumber> numbers{number<&Record::energy, &Energy::kinetic>("kinetic"),
                                              number<&Record::energy, &Energy::strain>("strain"),
                                              number<&Record::energy, &Energy::initial_total>("initial_total"),
                                              number<&Record::wall_seconds>("wall_seconds"),
                                              number<&Record::ns_per_particle_step>("ns_per_particle_step"),
                                              number<&Record::cost, &Cost::step_seconds>("step_seconds"),
                                              number<&Record::cost, &Cost::spread>("step_seconds_spread"),
                                              number<&Record::cfl>("cfl")};
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

std::string to_string(Failure f) {
  return failure_words.at(static_cast<std::size_t>(f));
}

Failure failure_from(const std::string& word) {
  return from_word<Failure>(failure_words, word, "failure");
}

Failure failure_of(const std::exception& e) {
  const bool of_machine =
      dynamic_cast<const std::bad_alloc*>(&e) != nullptr || dynamic_cast<const std::system_error*>(&e) != nullptr;
  return of_machine ? Failure::of_machine : Failure::of_case;
}

std::string to_string(PartVerdict v) {
  return verdict_words.at(static_cast<std::size_t>(v));
}

PartVerdict part_verdict_from(const std::string& word) {
  return from_word<PartVerdict>(verdict_words, word, "verdict of a claim's part");
}

}  // namespace mpmvv::records
