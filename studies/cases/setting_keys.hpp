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

/// Numbers in their shortest text that reads back as the same number.
std::string text_of(const Value& value);

enum class CasePart { problem, scheme, resolution, measure };

/// The member of a case that a key gives.
struct Member {
  CasePart part;
  std::function<Value(const Case&)> value;
  std::function<void(Case&, const Setting&)> set;  ///< empty where studies/settings has a rule for it
  std::vector<std::string> words = {};             ///< that it takes; empty for numbers, and for words of the solver's
  bool is_flag = false;                            ///< true or false
};

/// Of which solver's cases a key is.
enum class KeyOf { own, every, other };

/// What is said where a key may be left out, or must not be.
struct Absent {
  std::string help;       ///< of the option; empty: nothing
  std::string reference;  ///< of study files, what then counts; empty: it is required
};

/// A key that settings may have.
struct SettingKey {
  std::string key;
  std::string meaning;                ///< for help
  std::optional<Member> member = {};  ///< none where others follow from it
  KeyOf of = KeyOf::own;
  std::optional<Absent> absent = {};  ///< none: the member's value in `Case{}` counts

  /// Whether a case of the named code has it; empty: of our own solver.
  bool is_of(const std::string& code) const { return of == KeyOf::every || (of == KeyOf::other) == !code.empty(); }
};

/// All keys: the one place where they are named. Those with a member that a case has make its text, in this order.
const std::vector<SettingKey>& setting_keys();

}  // namespace mpmvv::cases
