#include "studies/claims/found_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mpmvv::claims {

std::string range_text(double lower, double upper) {
  if (std::isinf(upper)) return "without bounds";
  constexpr double round_off = 1e-12;
  if (!(upper - lower > round_off * std::max(std::abs(lower), std::abs(upper)))) return "";
  for (int digits = 3;; ++digits) {
    const std::string from = fmt::format("{:.{}g}", lower, digits), to = fmt::format("{:.{}g}", upper, digits);
    if (from != to) return from + " to " + to;
  }
}

std::string interval_text(const records::ClaimPart& part, const records::Found& found) {
  std::string beside, range;
  if (part.is_order()) {
    if (found.lower < found.value) beside = fmt::format(" ± {:.2g}", found.value - found.lower);
  } else if (part.is_limit()) {
    if (found.lower < found.upper && found.upper == found.value) beside = " or less";
    if (found.lower == found.value && std::isinf(found.upper)) beside = " or more";
  } else if (std::isfinite(found.value)) {
    range = range_text(found.lower, found.upper);
  }
  const std::string separator = range.empty() || found.remark.empty() ? "" : ", ";
  const std::string bracketed = range + separator + found.remark;
  return bracketed.empty() ? beside : fmt::format("{} ({})", beside, bracketed);
}

}  // namespace mpmvv::claims
