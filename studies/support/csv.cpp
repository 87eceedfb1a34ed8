#include "studies/support/csv.hpp"

#include <charconv>
#include <string_view>

namespace mpmvv::support {

namespace {

bool is_number(const std::string& text) {
  double ignored = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, ignored);
  return stop == end && error != std::errc::invalid_argument;
}

/// Whether a spreadsheet takes the text for a formula. Some skip a leading tab or line end before they look.
bool is_formula(const std::string& text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos &&
         !is_number(text);
}

}  // namespace

std::string csv_field(const std::string& text) {
  std::string harmless = is_formula(text) ? "'" + text : text;
  if (harmless.find_first_of(",\"\r\n") == std::string::npos) return harmless;
  std::string quoted = "\"";
  for (const char c : harmless) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (&field == &fields.front() ? "" : ",") + csv_field(field);
  return line + '\n';
}

}  // namespace mpmvv::support
