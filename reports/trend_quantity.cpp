#include "reports/trend_quantity.hpp"

#include <string_view>

namespace mpmvv::reports {

using claims::Finding;
using claims::Trend;

namespace {

/// The part of the trend's name that is its quantity.
std::string_view quantity_in(const Trend& trend) {
  const std::string_view name = trend.name, extrapolated = "extrapolated ";
  if (trend.kind == Finding::Kind::error) {
    const std::string_view before = "' in ";
    const auto at = name.rfind(before);
    return at == std::string_view::npos ? "" : name.substr(at + before.size());
  }
  if (trend.kind == Finding::Kind::limit) {
    const auto end = name.find(" limit of '");
    return end == std::string_view::npos ? "" : name.substr(0, end);
  }
  const auto end = name.find(" of '");
  if (trend.kind != Finding::Kind::value || !name.starts_with(extrapolated) || end == std::string_view::npos) return "";
  return name.substr(extrapolated.size(), end - extrapolated.size());
}

}  // namespace

std::string quantity_of(const Trend& trend) {
  return std::string(quantity_in(trend));
}

std::string label_with_unit(const Trend& trend) {
  const std::string_view quantity = quantity_in(trend);
  if (quantity.empty()) return label(trend);
  Trend with_unit = trend;
  with_unit.name.replace(static_cast<std::size_t>(quantity.data() - trend.name.data()), quantity.size(),
                         records::with_unit(std::string(quantity)));
  return label(with_unit);
}

}  // namespace mpmvv::reports
