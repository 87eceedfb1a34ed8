#pragma once
#include <kainjow/mustache.hpp>
#include <string>

namespace mpmvv::codes {

using TemplateFields = kainjow::mustache::data;

/// The template with its fields in place. UsageError, with `where`, of a template that is none and of an unknown field,
/// of that with its line in a text of several.
std::string filled(const std::string& text, const TemplateFields& fields, const std::string& where);

}  // namespace mpmvv::codes
