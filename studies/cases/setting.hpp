#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// Reads the values of settings. On a value without a meaning all functions throw UsageError, with key, value, place
/// and what would be right.
namespace mpmvv::cases {

/// One choice as a user wrote it, on the command line or in a study file.
struct Setting {
  std::string key;    ///< `cells`, `basis`, `param.amplitude`; as in study files, with `_` for `-`
  std::string value;  ///< as text
  std::string where;  ///< "--cells" or "studies/bar.toml:7", for messages
};

/// The sizes that a run can work with: the product of two such numbers neither overflows nor loses digits.
constexpr double least_size = 1e-150, largest_size = 1e150;
bool has_size(double value);

/// Read a finite number, which must be the whole text, and 0 or of such a size.
double parse_number(const Setting& setting);
double parse_number_in_size(const Setting& setting);  ///< its messages do not offer 0, for callers that refuse 0
double positive(const Setting& setting);
double not_negative(const Setting& setting);

/// Reads a whole number within these bounds.
std::int64_t whole(const Setting& setting, std::int64_t least, std::int64_t most);

/// Reads `true` or `false`.
bool parse_flag(const Setting& setting);

/// Throws UsageError where the value is not one of these words.
void require_word(const Setting& setting, const std::vector<std::string>& words);

}  // namespace mpmvv::cases
