#include "reports/criterion_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "studies/claims/found_text.hpp"

namespace mpmvv::reports {

namespace {

constexpr double bar_width = 96, bar_height = 14, edge = 7;  ///< pixels
constexpr double far_apart = 20;                             ///< a ratio

/// Maps numbers to pixels. Numbers beyond an end are drawn at that end.
class Scale {
 public:
  explicit Scale(const std::vector<double>& numbers) {
    const auto [least, most] = std::ranges::minmax(numbers);
    log_ = least > 0 && most / least > far_apart;
    from_ = scaled(least), to_ = scaled(most);
    const double margin = to_ > from_ ? 0.35 * (to_ - from_) : std::max(0.5 * std::abs(from_), 0.5);
    from_ -= margin, to_ += margin;
  }

  double pixel(double number) const {
    const double fraction = (scaled(number) - from_) / (to_ - from_);
    return edge + std::clamp(fraction, 0.0, 1.0) * (bar_width - 2 * edge);
  }

 private:
  double scaled(double number) const { return log_ ? std::log10(std::max(number, 1e-300)) : number; }

  bool log_ = false;
  double from_ = 0, to_ = 1;
};

/// The numbers that the scale must hold: the bounds and what was found; also zero, as the natural end of a scale of
/// positive numbers with one bound.
std::vector<double> numbers_of(const records::ClaimPart& part) {
  std::vector<double> numbers;
  const auto add = [&](double number) {
    if (std::isfinite(number)) numbers.push_back(number);
  };
  for (const auto& bound : {part.at_least, part.at_most})
    if (bound) add(*bound);
  for (const records::Found& found : part.found) add(found.value);
  const auto [least, most] = std::ranges::minmax(numbers);
  if (!(part.at_least && part.at_most) && least > 0 && most / least <= far_apart) numbers.push_back(0);
  return numbers;
}

/// The line of an interval; empty where it is a number alone.
std::string reach(const Scale& scale, const records::Found& found) {
  if (!claims::has_interval(found)) return "";
  return fmt::format(R"(<path class="reach" d="M{:.3g} {:g}H{:.3g}"/>)", scale.pixel(found.lower), bar_height / 2,
                     scale.pixel(found.upper));
}

}  // namespace

std::string criterion_bar(const records::ClaimPart& part, const records::Found& found) {
  const auto& [at_least, at_most] = std::tie(part.at_least, part.at_most);
  const double value = found.value;
  if ((!at_least && !at_most) || std::isnan(value)) return "";
  const Scale scale(numbers_of(part));
  const double left = at_least ? scale.pixel(*at_least) : 0, right = at_most ? scale.pixel(*at_most) : bar_width;
  const double at = std::isfinite(value) ? scale.pixel(value) : value > 0 ? bar_width - edge / 2 : edge / 2;
  const bool holds = (!at_least || value >= *at_least) && (!at_most || value <= *at_most);
  return fmt::format(
      R"(<svg class="bar" aria-hidden="true"><path d="M0 {0:g}H{1:g}"/>)"
      R"(<path class="band" d="M{2:.3g} {0:g}h{3:.3g}"/>{6}<path class="{4}" d="M{5:.3g} {0:g}h0"/></svg>)",
      bar_height / 2, bar_width, left, std::max(1.0, right - left), holds ? "within" : "beyond", at,
      reach(scale, found));
}

}  // namespace mpmvv::reports
