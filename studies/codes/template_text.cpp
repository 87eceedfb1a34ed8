#include "studies/codes/template_text.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// Returns `where`, with the line of the first tag of this name if the text has several lines.
std::string place_of(const std::string& name, const std::string& text, const std::string& where) {
  if (text.find('\n') == std::string::npos) return where;
  for (auto tag = text.find("{{"); tag != std::string::npos; tag = text.find("{{", tag + 2)) {
    const auto begin = std::min(text.find_first_not_of("{#^& ", tag), text.size());
    const auto end = text.find_first_of(" }", begin);
    if (text.substr(begin, end - begin) == name)
      return fmt::format("{}:{}", where,
                         std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(tag), '\n') + 1);
  }
  return where;
}

/// Whether the name is that of a component along an axis that the case lacks: with x in the place of y or z it exists.
bool is_of_more_dimensions(std::string name, const TemplateFields& fields) {
  const auto axis = std::string_view("yzYZ").find(name.back());
  if (axis == std::string_view::npos) return false;
  name.back() = axis < 2 ? 'x' : 'X';
  return fields.get(name) != nullptr;
}

}  // namespace

std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where) {
  mustache::mustache page(text);
  page.set_custom_escape([](const std::string& value) { return value; });
  if (!page.is_valid())
    throw support::UsageError(
        fmt::format("{} is no template ({}; docs/adapters.md shows what one is)", where, page.error_message()));
  StrictContext context(&fields);
  std::string result = page.render(context);
  if (const std::string& missing = context.missing(); !missing.empty())
    throw support::UsageError(
        fmt::format("unknown field '{}' in {} ({})", missing, place_of(missing, text, where),
                    is_of_more_dimensions(missing, fields)
                        ? "the case has fewer dimensions: between {{#is_plane}} and {{/is_plane}}, or is_solid"
                        : "docs/adapters.md lists them, beside those of the adapter's [fields] and [variants]"));
  return result;
}

}  // namespace mpmvv::codes
