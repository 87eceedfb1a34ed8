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

const std::vector<std::string>& norm_words() {
  static const std::vector<std::string> words{"l1",
                                              "l2",
                                              "linf",
                                              "l1_all_steps",
                                              "l2_all_steps",
                                              "linf_all_steps",
                                              "nodal_l1",
                                              "nodal_l2",
                                              "nodal_linf",
                                              "velocity_error",
                                              "stress_error",
                                              "energy_loss",
                                              "mass_change",
                                              "momentum_change",
                                              "angular_momentum_change"};
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
