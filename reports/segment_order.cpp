#include "reports/segment_order.hpp"

#include <algorithm>

namespace mpmvv::reports {

double segment_order(const records::Series& series, const std::string& norm, double x) {
  for (const auto& order : series.orders) {
    if (order.norm != norm) continue;
    const auto segment = std::ranges::find(order.segments, x, &fits::SegmentOrder::to);
    if (segment != order.segments.end()) return segment->order;
  }
  return support::not_measured;
}

}  // namespace mpmvv::reports
