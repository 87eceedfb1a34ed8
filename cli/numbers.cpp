#include "cli/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mpmvv::cli {

namespace {

std::string formatted(const char* format, double value) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

}  // namespace

std::string number_text(double value) {
  return formatted("{:.4g}", value);
}

std::string error_text(double value) {
  return formatted("{:.3e}", value);
}

std::string order_text(double order) {
  return formatted("{:.2f}", std::abs(order) < 0.005 ? 0 : order);  // no -0.00
}

std::string half_width_text(double half_width) {
  return half_width == 0 ? "-" : formatted("± {:.2g}", half_width);
}

std::string count_text(std::size_t n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many.empty() ? one + "s" : many);
}

std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 0.05 && seconds > 0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 10 * minute) return fmt::format("{:.1f} min", seconds / minute);
  return seconds < 2 * hour ? fmt::format("{:.0f} min", seconds / minute) : fmt::format("{:.1f} h", seconds / hour);
}

}  // namespace mpmvv::cli
