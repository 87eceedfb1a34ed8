#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/cases/setting.hpp"

namespace mpmvv::cases {

using Value = std::variant<bool, std::int64_t, double, std::string>;

/// Returns the text of a value: of a number the shortest one that reads back as the same number.
std::string text_of(const Value& value);

enum class CasePart { problem, scheme, resolution, measure };

/// The member of a case that a key gives.
struct Member {
  CasePart part;
  std::function<Value(const Case&)> value;
  std::function<void(Case&, const Setting&)> set;  ///< empty where studies/settings has a rule
  std::vector<std::string> words = {};             ///< words that it takes; empty for numbers and the solver's words
  bool is_flag = false;                            ///< whether it is true or false
};

/// Which cases have a key: those of our own solver, every one, or those of other codes.
enum class KeyOf { own, every, other };

/// What texts say of a case without the key, where the default of the member does not say it.
struct Absent {
  std::string help;       ///< in the help of the option; empty: nothing
  std::string reference;  ///< in the reference of study files, what then counts; empty: the key is required
};

/// A key that settings may have.
struct SettingKey {
  std::string key;
  std::string meaning;                ///< one line, for help and reference
  std::optional<Member> member = {};  ///< none for `problem`, `cfl` and `end_time`
  KeyOf of = KeyOf::own;
  std::optional<Absent> absent = {};  ///< none: the member's value in `Case{}` counts

  /// Whether a case of this code has the key. An empty word is our own solver.
  bool is_of(const std::string& code) const { return of == KeyOf::every || (of == KeyOf::other) == !code.empty(); }
};

/// All keys. This is the one place where they are listed. In a case's text those with a member that the case has stand
/// in this order, after the problem, its parameters and the end time.
const std::vector<SettingKey>& setting_keys();

}  // namespace mpmvv::cases
