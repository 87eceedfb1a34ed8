#include "studies/claims/found_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mpmvv::claims {

std::pair<std::string, std::string> told_apart(double a, double b, int digits) {
  constexpr int all_digits = 17;
  const auto rounded = [&digits](double number) { return fmt::format("{:.{}g}", number, digits); };
  while (a != b && digits < all_digits && rounded(a) == rounded(b)) ++digits;
  return {rounded(a), rounded(b)};
}

std::string bounds_text(const records::ClaimPart& part) {
  if (part.at_least && part.at_least == part.at_most) return fmt::format("{}", *part.at_least);
  if (part.at_least && part.at_most) return fmt::format("{} to {}", *part.at_least, *part.at_most);
  if (part.at_least) return fmt::format("at least {}", *part.at_least);
  return part.at_most ? fmt::format("at most {}", *part.at_most) : "";
}

std::string told_from_bounds(const records::ClaimPart& part, double value) {
  if (value == part.at_least || value == part.at_most) return fmt::format("{}", value);
  int digits = 4;
  const auto rounded = [&digits](double v) { return fmt::format("{:.{}g}", v, digits); };
  const auto looks_like = [&](const std::optional<double>& bound) {
    return bound && rounded(value) == rounded(*bound);
  };
  while (digits < 17 && (looks_like(part.at_least) || looks_like(part.at_most))) ++digits;
  return rounded(value);
}

std::string range_text(double lower, double upper) {
  if (std::isinf(lower) || std::isinf(upper)) return "without bounds";
  constexpr double round_off = 1e-12;
  if (!(upper - lower > round_off * std::max(std::abs(lower), std::abs(upper)))) return "";
  const auto [from, to] = told_apart(lower, upper, 3);
  return from + " to " + to;
}

bool has_interval(const records::Found& found) {
  return std::isfinite(found.value) && !range_text(found.lower, found.upper).empty();
}

std::string interval_text(const records::ClaimPart& part, const records::Found& found) {
  if (!has_interval(found)) return "";
  if (part.is_order()) return fmt::format(" ± {:.2g}", found.value - found.lower);
  if (!part.is_limit()) return fmt::format(" ({})", range_text(found.lower, found.upper));
  if (found.upper == found.value) return " or less";
  return std::isinf(found.upper) ? " or more" : "";
}

std::string interval_and_remark(const records::ClaimPart& part, const records::Found& found) {
  std::string interval = interval_text(part, found);
  if (found.remark.empty()) return interval;
  if (!interval.ends_with(')')) return fmt::format("{} ({})", interval, found.remark);
  return fmt::format("{}, {})", interval.substr(0, interval.size() - 1), found.remark);
}

}  // namespace mpmvv::claims
