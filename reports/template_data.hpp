#pragma once
#include <fmt/format.h>

#include <cctype>
#include <initializer_list>
#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/picture.hpp"

/// What a page's template is filled with.
namespace mpmvv::reports::template_data {

using kainjow::mustache::data;

inline data text_list(const std::vector<std::string>& texts) {
  data list{data::type::list};
  for (const auto& t : texts) list << data(t);
  return list;
}

template <typename Range, typename Entry>
data list_of(const Range& range, Entry entry) {
  data list{data::type::list};
  for (const auto& item : range) list << entry(item);
  return list;
}

inline data object(std::initializer_list<std::pair<const char*, data>> members) {
  data result;
  for (const auto& [name, value] : members) result.set(name, value);
  return result;
}

/// A name as part of an id. Different names make different ids: what is neither letter, digit, `-` nor `.` becomes `_`
/// and its code.
inline std::string anchor(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = byte < 0x80 && (std::isalnum(byte) != 0 || c == '-' || c == '.');
    result += stays ? std::string(1, c) : fmt::format("_{:02X}", byte);
  }
  return result;
}

inline data partial(std::string_view text) {
  return kainjow::mustache::partial([text] { return std::string(text); });
}

inline data picture_data(const Picture& p) {
  return object({{"figure", p.name},
                 {"figure_anchor", anchor(p.name)},
                 {"folder", p.folder},
                 {"caption", p.caption},
                 {"notes", text_list(p.notes)},
                 {"description", p.description},
                 {"width", fmt::format("{}", p.width)},
                 {"height", fmt::format("{}", p.height)},
                 {"has_points", !p.points.empty()}});
}

}  // namespace mpmvv::reports::template_data
