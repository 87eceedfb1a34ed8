#include "studies/codes/template_text.hpp"

#include <fmt/format.h>

#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace {

namespace mustache = kainjow::mustache;

/// Notes the first field that is asked for and not there.
class StrictContext : public mustache::context<std::string> {
 public:
  using context::context;

  const Fields* get(const std::string& name) const override {
    const Fields* found = context::get(name);
    if (!found && missing_.empty()) missing_ = name;
    return found;
  }

  const std::string& missing() const { return missing_; }

 private:
  mutable std::string missing_;
};

}  // namespace

std::string filled(const std::string& text, const Fields& fields, const std::string& where) {
  mustache::mustache page(text);
  page.set_custom_escape([](const std::string& value) { return value; });
  if (!page.is_valid())
    throw support::UsageError(
        fmt::format("{} is no template ({}; docs/adapters.md shows what one is)", where, page.error_message()));
  StrictContext context(&fields);
  std::string result = page.render(context);
  if (!context.missing().empty())
    throw support::UsageError(
        fmt::format("unknown field '{}' in {} (docs/adapters.md lists them, beside those of the "
                    "adapter's [fields] and [variants])",
                    context.missing(), where));
  return result;
}

}  // namespace mpmvv::codes
