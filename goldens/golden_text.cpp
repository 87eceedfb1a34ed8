#include <fmt/format.h>

#include <cmath>

#include "goldens/golden.hpp"

namespace mpmvv::goldens {

namespace {

struct SubjectOf {
  std::string operator()(const OrderGolden& g) const {
    const std::string over = g.window.empty() ? "" : fmt::format(" over [{:g}, {:g}]", g.window[0], g.window[1]);
    return fmt::format("order of '{}' in {}{}", g.series, g.norm, over);
  }
  std::string operator()(const ErrorGolden& g) const {
    return fmt::format("error of '{}' in {} at {}", g.series, g.norm, g.at);
  }
  std::string operator()(const LimitGolden& g) const { return fmt::format("limit of '{}'", g.series); }
  std::string operator()(const ValueGolden& g) const { return fmt::format("value '{}'", g.name); }
  std::string operator()(const StatusGolden& g) const { return fmt::format("status of '{}' at {}", g.series, g.at); }
};

struct ExpectedTextOf {
  std::string operator()(const OrderGolden& g) const {
    return fmt::format("{:.6g} in [{:.6g}, {:.6g}]", g.expected, g.lower, g.upper);
  }
  std::string operator()(const ErrorGolden& g) const {
    return fmt::format("{:.6g} ± {:g} %", g.expected, 100 * g.band);
  }
  std::string operator()(const LimitGolden& g) const {
    return fmt::format("{:.6g} ± {:g} %", g.expected, 100 * g.band);
  }
  std::string operator()(const ValueGolden& g) const {
    if (std::isinf(g.lower)) return fmt::format("at most {:.6g}", g.upper);
    if (std::isinf(g.upper)) return fmt::format("at least {:.6g}", g.lower);
    return fmt::format("in [{:.6g}, {:.6g}]", g.lower, g.upper);
  }
  std::string operator()(const StatusGolden& g) const { return to_string(g.expected); }
};

}  // namespace

std::string subject(const Golden& golden) {
  return std::visit(SubjectOf{}, golden.expectation);
}

std::string expected_text(const Golden& golden) {
  return std::visit(ExpectedTextOf{}, golden.expectation);
}

}  // namespace mpmvv::goldens
