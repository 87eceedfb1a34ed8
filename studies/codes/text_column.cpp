#include "studies/codes/text_column.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <string>

namespace mpmvv::codes {

namespace {

/// What the text of a number shows of its rounding.
struct Shown {
  int digits = 0, decimals = 0;
  bool has_exponent = false;
};

Shown shown_by(std::string_view text) {
  Shown shown;
  bool leading = true, behind_point = false;
  for (const char c : text) {
    if (c == 'e') {
      shown.has_exponent = true;
      break;
    }
    if (c == '.') behind_point = true;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    leading = leading && c == '0';
    if (!leading) ++shown.digits;
    if (behind_point) ++shown.decimals;
  }
  return shown;
}

}  // namespace

bool add_text(TableColumn& column, std::string_view text) {
  std::string plain(text);
  for (char& c : plain) c = c == 'E' || c == 'd' || c == 'D' ? 'e' : c;
  if (plain.starts_with('+')) plain.erase(0, 1);
  double value = 0;
  const char* end = plain.data() + plain.size();
  const auto [stop, error] = std::from_chars(plain.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range) value = std::strtod(plain.c_str(), nullptr);  // infinite, or nearly 0
  const Shown shown = shown_by(plain);
  const int decimals = shown.has_exponent ? -1 : shown.decimals;
  if (column.values.empty()) column.decimals = decimals;
  if (column.decimals != decimals) column.decimals = -1;
  const bool is_padded = shown.decimals > 1 && std::string_view(plain).substr(0, plain.find('e')).ends_with('0');
  column.is_padded = column.is_padded || is_padded;
  column.digits = std::max(column.digits, shown.digits);
  column.values.push_back(value);
  return true;
}

}  // namespace mpmvv::codes
