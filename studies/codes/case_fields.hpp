#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace mpmvv::codes {

/// UsageError that names the field, unless all that a case's file must have is there, of the right type, and nothing
/// else.
void require_case_fields(const nlohmann::json& object, const std::string& file);

/// UsageError that names the first field that has another value than that of the same case's file would have.
void require_same_fields(const nlohmann::json& object, const nlohmann::json& wanted, const std::string& file);

[[noreturn]] void fail_case(const std::string& file, const std::string& why);

}  // namespace mpmvv::codes
