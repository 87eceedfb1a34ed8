#include "studies/codes/template_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <vector>

#include "studies/codes/field_names.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace {

namespace mustache = kainjow::mustache;

/// A context that notes the first field that a template names and that does not exist.
class StrictContext : public mustache::context<std::string> {
 public:
  using context::context;

  const TemplateFields* get(const std::string& name) const override {
    const TemplateFields* found = context::get(name);
    if (!found && missing_.empty()) missing_ = name;
    return found;
  }

  const std::string& missing() const { return missing_; }

 private:
  mutable std::string missing_;
};

constexpr const char* of_braces =
    "{{{ begins a tag of its own: other delimiters, {{=<% %>=}}, where a { stands before a tag; docs/adapters.md";

/// Returns `where`, with the line of this place if the text has several lines and the place is in it.
std::string line_of(std::size_t place, const std::string& text, const std::string& where) {
  if (place >= text.size() || text.find('\n') == std::string::npos) return where;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
  return fmt::format("{}:{}", where, std::count(text.begin(), end, '\n') + 1);
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\v\f\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

struct Tag {
  std::size_t place;
  std::string_view inside;  ///< what stands between its delimiters, without blanks around it
};

/// Returns the tags of a text up to the first that the library refuses.
std::vector<Tag> tags_of(std::string_view text) {
  std::vector<Tag> tags;
  std::string_view open = "{{", close = "}}";
  for (auto place = text.find(open); place != std::string_view::npos;) {
    const bool is_of_three = open == "{{" && close == "}}" && text.substr(place).starts_with("{{{");
    const std::string_view end = is_of_three ? "}}}" : close;
    const auto begin = place + open.size(), behind = text.find(end, begin);
    if (behind == std::string_view::npos) break;
    const std::string_view inside = without_blanks(text.substr(begin, behind - begin));
    tags.push_back({place, inside});
    if (inside.starts_with('=')) {
      const std::string_view delimiters = without_blanks(inside.substr(1, inside.size() - 2));
      if (delimiters.find(' ') == std::string_view::npos) break;
      open = delimiters.substr(0, delimiters.find(' '));
      close = delimiters.substr(delimiters.rfind(' ') + 1);
    }
    place = text.find(open, behind + end.size());
  }
  return tags;
}

/// Returns where the first tag of this name begins; npos if that is not found.
std::size_t tag_of(std::string_view name, std::string_view text) {
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  name.remove_prefix(std::min(name.find_first_not_of('{'), name.size()));
  for (const Tag& tag : tags_of(text)) {
    const std::string_view inside =
        tag.inside.substr(std::min(tag.inside.find_first_not_of("{#^& "), tag.inside.size()));
    if (inside.starts_with(name) && (inside.size() == name.size() || !is_of_name(inside[name.size()])))
      return tag.place;
  }
  return std::string_view::npos;
}

/// Throws where sections stand too deep in one another: the library calls itself for each.
void require_shallow_sections(const std::string& text, const std::string& where) {
  constexpr int deepest = 64;
  int depth = 0;
  for (const auto& [place, inside] : tags_of(text)) {
    if (inside.starts_with('#') || inside.starts_with('^')) ++depth;
    if (inside.starts_with('/')) --depth;
    if (depth > deepest)
      throw support::UsageError(
          fmt::format("sections too deep in one another in {} (at most {})", line_of(place, text, where), deepest));
  }
}

/// Throws the error of a text that is no template. It says at which character, as in "Unclosed tag at 20".
[[noreturn]] void refuse_template(const std::string& error, const std::string& text, const std::string& where) {
  const std::string at = " at ";
  const auto split = error.rfind(at);
  std::size_t place = std::string::npos;
  if (split != std::string::npos) std::from_chars(error.data() + split + at.size(), error.data() + error.size(), place);
  const bool has_braces = place < text.size() && text.compare(place, 3, "{{{") == 0;
  throw support::UsageError(fmt::format("{} is no template ({}; {})", line_of(place, text, where),
                                        error.substr(0, split),
                                        has_braces ? of_braces : "docs/adapters.md shows what one is"));
}

/// Returns the face that the name speaks of, as xmin_position does; empty if there is none.
std::string face_in(const std::string& name) {
  for (std::size_t face = 0; face < 6; ++face)
    if (name.find(face_name(face)) != std::string::npos) return face_name(face);
  return "";
}

bool is_motion_of(const std::string& face, const std::string& name) {
  return name == face + "_position" || name == face + "_velocity";
}

/// Whether the name is that of a component or a face along an axis that the case lacks: with x in the place of y or z
/// it exists.
bool is_of_more_dimensions(std::string name, const TemplateFields& fields) {
  if (const std::string face = face_in(name); !face.empty()) {
    if (fields.get("boundary_" + face)) return false;
    if (is_motion_of(face, name)) return true;
    name[name.find(face)] = 'x';
    return fields.get(name) != nullptr;
  }
  const auto axis = std::string_view("yzYZ").find(name.back());
  if (axis == std::string_view::npos) return false;
  name.back() = axis < 2 ? 'x' : 'X';
  return fields.get(name) != nullptr;
}

/// Says what may be meant by a field that does not exist.
std::string hint(const std::string& name, const TemplateFields& fields) {
  if (name.find_first_of("{}") != std::string::npos) return of_braces;
  if (is_of_more_dimensions(name, fields))
    return "the case has fewer dimensions: between {{#is_plane}} and {{/is_plane}}, or is_solid";
  if (const std::string face = face_in(name); is_motion_of(face, name))
    return fmt::format(
        "the face has no wall whose motion is known here: between {{{{#{0}_is_wall}}}} and {{{{/{0}_is_wall}}}}", face);
  return "docs/adapters.md lists them and says where they may stand, beside those of the adapter's [fields] and "
         "[variants]";
}

}  // namespace

std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where) {
  require_shallow_sections(text, where);
  mustache::mustache page(text);
  page.set_custom_escape([](const std::string& value) { return value; });
  if (!page.is_valid()) refuse_template(page.error_message(), text, where);
  StrictContext context(&fields);
  std::string result = page.render(context);
  if (const std::string& missing = context.missing(); !missing.empty())
    throw support::UsageError(fmt::format("unknown field '{}' in {} ({})", missing,
                                          line_of(tag_of(missing, text), text, where), hint(missing, fields)));
  return result;
}

}  // namespace mpmvv::codes
