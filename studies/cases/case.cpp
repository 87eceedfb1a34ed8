#include "studies/cases/case.hpp"

#include <fmt/format.h>

#include "studies/cases/setting_keys.hpp"

namespace mpmvv::cases {

Method method_of(const Scheme& scheme) {
  if (!scheme.code.empty()) return {scheme.code, scheme.variant, ""};
  return {scheme.basis, scheme.integrator, scheme.velocity_update};
}

std::string canonical_text(const Case& c) {
  std::string text = "problem=" + c.problem.name;
  const auto add = [&text](const std::string& key, const Value& value) { text += " " + key + "=" + text_of(value); };
  for (const auto& [key, value] : c.problem.parameters) add("param." + key, value + 0.0);  // -0 becomes 0: one text
  add("end_time", c.problem.end_time + 0.0);
  for (const SettingKey& key : setting_keys())
    if (key.member && key.is_of(c.scheme.code)) add(key.key, key.member->value(c));
  return text;
}

std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace mpmvv::cases
