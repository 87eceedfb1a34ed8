#include "studies/codes/template_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

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

/// Returns where the first tag of this name begins; npos if that is not found.
std::size_t tag_of(std::string_view name, std::string_view text) {
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  name.remove_prefix(std::min(name.find_first_not_of('{'), name.size()));
  std::string_view open = "{{";
  for (auto tag = text.find(open); tag != std::string_view::npos; tag = text.find(open, tag + open.size())) {
    const std::string_view rest = text.substr(tag + open.size());
    const std::string_view inside = rest.substr(std::min(rest.find_first_not_of("{#^& "), rest.size()));
    if (inside.starts_with(name) && (inside.size() == name.size() || !is_of_name(inside[name.size()]))) return tag;
    if (!rest.starts_with('=')) continue;
    const auto begin = rest.find_first_not_of(" \t\n", 1);  // of a template that was found valid
    open = rest.substr(begin, rest.find_first_of(" \t\n", begin) - begin);
  }
  return std::string_view::npos;
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
  return "docs/adapters.md lists them, beside those of the adapter's [fields] and [variants]";
}

}  // namespace

std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where) {
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
