#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "reports/utf8.hpp"
#include "studies/fits/stability_limit.hpp"

namespace mpmvv::reports {

std::string exact(double v) {
  return std::isnan(v) ? "" : fmt::format("{:.17g}", v);
}

std::string brief(double v) {
  if (std::isnan(v)) return "–";
  constexpr double least_rounded = 1e6;
  const bool is_short_whole = v == std::trunc(v) && std::abs(v) < least_rounded;
  return is_short_whole ? fmt::format("{:.0f}", v) : fmt::format("{:.4g}", v);
}

std::string window_text(double from, double to) {
  return fmt::format("{} to {}", brief(from), brief(to));
}

std::string growth_text(std::int64_t steps) {
  const double per_cent = 100 * (fits::least_visible_growth(steps) - 1);
  if (std::isnan(per_cent)) return "";
  return per_cent < 99.5 ? fmt::format("{:.2g} %", per_cent) : fmt::format("{:.0f} %", per_cent);
}

std::string three_digits(double v) {
  if (std::isnan(v)) return "–";
  return std::abs(v) < 99.95 ? fmt::format("{:#.3g}", v) : fmt::format("{:.0f}", v);
}

bool is_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  return text == "–" || (!text.empty() && std::from_chars(text.data(), end, value).ptr == end);
}

std::string order_text(double order, double half_width) {
  if (std::isnan(order)) return "–";
  const int decimals = half_width > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(half_width))), 2, 4) : 2;
  const bool is_shown_as_zero = std::abs(order) < 0.5 * std::pow(10, -decimals);
  std::string text = fmt::format("{:.{}f}", is_shown_as_zero ? 0 : order, decimals);  // no -0.00
  if (std::isnan(half_width)) return text;
  constexpr double least_shown = 5e-5;
  if (half_width > 0 && half_width < least_shown) return fmt::format("{} ± {:.0e}", text, half_width);
  return fmt::format("{} ± {:.{}f}", text, half_width, decimals);
}

std::string order_text(const fits::ObservedOrder& fit) {
  const double half_width = fits::half_width(fit);
  return order_text(fit.order, half_width > 0 ? half_width : fits::not_measured);
}

namespace {

/// Whether the bytes are a character.
bool is_utf8(std::string_view character) {
  static constexpr unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
  const auto lead = static_cast<unsigned char>(character[0]);
  const auto follows = [](char c) { return (c & 0xC0) == 0x80; };
  if (lead >= 0xF8 || character.size() != utf8_length(lead) || !std::ranges::all_of(character.substr(1), follows))
    return false;
  const unsigned code = code_point(character);
  return code >= least[character.size()] && (character.size() > 1 || code < 0x80) && code <= 0x10FFFF &&
         (code < 0xD800 || code > 0xDFFF);
}

/// Whether HTML and XML can hold the character.
bool is_markup_character(std::string_view character) {
  const unsigned code = code_point(character);
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  const auto within = [code](unsigned from, unsigned to) { return code >= from && code <= to; };
  return !within(0x7F, 0x9F) && !within(0xFDD0, 0xFDEF) && (code & 0xFFFEu) != 0xFFFE;
}

}  // namespace

std::string marked_up_text(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    auto character = std::string_view(text).substr(i, utf8_length(static_cast<unsigned char>(text[i])));
    const bool is_character = is_utf8(character);
    if (!is_character) character = character.substr(0, 1);
    result += is_character && is_markup_character(character) ? character : "\uFFFD";
    i += character.size();
  }
  return result;
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace mpmvv::reports
