#pragma once
#include <kainjow/mustache.hpp>
#include <string>

namespace mpmvv::codes {

using TemplateFields = kainjow::mustache::data;

/// Returns the template with its fields filled in. Throws UsageError, which says `where`, for an invalid template and
/// for an unknown field. For the field it also says the line, if the template has several.
std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where);

}  // namespace mpmvv::codes
