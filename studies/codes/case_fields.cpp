#include "studies/codes/case_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "studies/support/error.hpp"

namespace mpmvv::codes {

using nlohmann::json;

namespace {

struct CaseField {
  const char* name;
  bool (*is_right)(const json&);
  const char* type;
};

bool is_text(const json& value) {
  return value.is_string();
}
bool is_number(const json& value) {
  return value.is_number();
}
bool is_whole(const json& value) {
  return value.is_number_integer();
}
bool is_list_of_texts(const json& value) {
  return value.is_array() && std::ranges::all_of(value, is_text);
}
bool has_texts(const json& value) {
  return value.is_object() && std::ranges::all_of(value, is_text);
}
bool has_numbers(const json& value) {
  return value.is_object() && std::ranges::all_of(value, is_number);
}

constexpr std::array case_fields{
    CaseField{"case", is_text, "a text"},
    CaseField{"problem", is_text, "a text"},
    CaseField{"parameters", has_numbers, "an object of numbers"},
    CaseField{"settings", has_texts, "an object of texts"},
    CaseField{"dimension", is_whole, "a whole number"},
    CaseField{"end_time", is_number, "a number"},
    CaseField{"dt", is_number, "a number"},
    CaseField{"steps", is_whole, "a whole number"},
    CaseField{"h", is_number, "a number"},
    CaseField{"columns", is_list_of_texts, "a list of texts"},
    CaseField{"units", has_texts, "an object of texts"},
};

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const CaseField& field : case_fields) names.emplace_back(field.name);
  return names;
}

std::string brief(const json& value) {
  constexpr std::size_t longest = 60;
  const std::string text = value.dump();
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

/// As `brief`; a list or an object by its kind alone, as dump() calls itself for each of their levels.
std::string kind_or_text(const json& value) {
  if (value.is_array()) return "a list";
  return value.is_object() ? "an object" : brief(value);
}

}  // namespace

void require_case_fields(const json& object, const std::string& file) {
  if (!object.is_object()) fail_case(file, "no object");
  for (const auto& [key, value] : object.items())
    if (std::ranges::none_of(case_fields, [&](const CaseField& field) { return key == field.name; }))
      throw support::UsageError(
          fmt::format("unknown field '{}' in {} (known: {})", key, file, fmt::join(field_names(), ", ")));
  for (const CaseField& field : case_fields) {
    if (!object.contains(field.name)) fail_case(file, fmt::format("no field '{}'", field.name));
    const json& value = object[field.name];
    if (!field.is_right(value))
      fail_case(file, fmt::format("{} = {}, which is not {},", field.name, kind_or_text(value), field.type));
  }
}

void require_same_fields(const json& object, const json& wanted, const std::string& file) {
  for (const auto& [key, value] : wanted.items())
    if (key != "settings" && key != "columns" && object[key] != value)
      fail_case(file, fmt::format("{} = {}, where its text has {},", key, brief(object[key]), brief(value)));
}

void fail_case(const std::string& file, const std::string& why) {
  throw support::UsageError(fmt::format("{} in {} (a case, as `mpmvv case` writes it)", why, file));
}

}  // namespace mpmvv::codes
