#pragma once
#include <kainjow/mustache.hpp>
#include <string>

namespace mpmvv::codes {

using TemplateFields = kainjow::mustache::data;

/// Returns the template with its fields filled in. Throws UsageError for an invalid template and for an unknown
/// field. It says `where` and, if the template has several lines and the place is found, the line.
std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where);

}  // namespace mpmvv::codes
