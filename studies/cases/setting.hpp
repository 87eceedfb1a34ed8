#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// The values that settings give. What has no meaning is a UsageError with key, value, place and what would be right.
namespace mpmvv::cases {

/// One choice as a user wrote it, on the command line or in a study file.
struct Setting {
  std::string key;    ///< `cells`, `basis`, `param.amplitude`; a study file's spelling, `_` for `-`
  std::string value;  ///< as text
  std::string where;  ///< "--cells" or "studies/bar.toml:7", for messages
};

/// What a run can work with: products of two such sizes are numbers with all their digits.
constexpr double least_size = 1e-150, largest_size = 1e150;
bool has_size(double value);

/// A number, wholly and finite.
double parse_number(const Setting& setting);
double parse_number_in_size(const Setting& setting);  ///< where 0 is refused later: no message offers it
double positive(const Setting& setting);
double not_negative(const Setting& setting);

/// A whole number within these bounds.
std::int64_t whole(const Setting& setting, std::int64_t least, std::int64_t most);

/// `true` or `false`.
bool parse_flag(const Setting& setting);

/// One of these words.
void require_word(const Setting& setting, const std::vector<std::string>& words);

}  // namespace mpmvv::cases
