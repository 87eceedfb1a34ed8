#pragma once
#include <string>
#include <vector>

namespace mpmvv::store {

/// The text of a study with one more line, which says what `study --set` has put on top of it. The store keeps the text
/// with this line.
std::string with_trial(std::string text, const std::string& what);

/// The text without such lines.
std::string without_trial(const std::string& text);

/// What `study --set` has put on top of the study that has this text in the store, "shuffle = 3 in 2 of 2 series";
/// empty for a study as its file has it.
std::string trial_of(const std::string& text);

struct TrialSetting {
  std::string key, value;
  bool in_all;  ///< all series have it, not only those that take it
};

/// The settings of a trial, in their order. Empty where `trial` is not what `trial_of` returns.
std::vector<TrialSetting> settings_of(const std::string& trial);

}  // namespace mpmvv::store
