#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace mpmvv::codes {

/// Throws UsageError, which names the field, unless the object has every field of a case's file with the right type and
/// no other field.
void require_case_fields(const nlohmann::json& object, const std::string& file);

/// Throws UsageError, which names the field, if a field of `object` has another value than in `wanted`, the file that
/// mpmvv writes of the same case. `settings` and `columns` are not compared.
void require_same_fields(const nlohmann::json& object, const nlohmann::json& wanted, const std::string& file);

[[noreturn]] void fail_case(const std::string& file, const std::string& why);

}  // namespace mpmvv::codes
