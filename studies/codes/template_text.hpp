#pragma once
#include <kainjow/mustache.hpp>
#include <string>

namespace mpmvv::codes {

using Fields = kainjow::mustache::data;

/// The template with its fields in place. UsageError, with `where`, of a template that is none and of an unknown field.
std::string filled(const std::string& text, const Fields& fields, const std::string& where);

}  // namespace mpmvv::codes
