#include "cli/change_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/claims/found_text.hpp"

namespace mpmvv::cli {

using claims::Finding;

namespace {

/// The difference of two numbers as a text; empty where one is a word or they are errors at different levels.
std::string difference(const Finding& before, const Finding& after) {
  const double a = before.number, b = after.number;
  const bool same_level = before.at == after.at || std::isnan(before.at);
  if (!before.word.empty() || !after.word.empty() || !same_level || !std::isfinite(b - a)) return "";
  if (before.kind == Finding::Kind::order || a == 0) return fmt::format(" ({:+.3g})", b - a);
  if (before.kind == Finding::Kind::cost) return fmt::format(" (x {:.3f})", b / a);
  return fmt::format(" ({:+.3g} %)", 100 * (b - a) / std::abs(a));
}

std::string largest_text(const goldens::Change::AtLevel& largest) {
  const auto [before, after] = claims::told_apart(largest.before, largest.after, 6);
  return fmt::format("most at {:g}: {} -> {}", largest.x, before, after);
}

}  // namespace

std::string change_text(const goldens::Change& change) {
  const std::string& name = change.before.name;
  if (goldens::is_curve(change.before))
    return fmt::format("{}: {}", name, change.largest ? largest_text(*change.largest) : "the same where both have it");
  std::string text = fmt::format("{}: {} -> {}{}", name, claims::text(change.before), claims::text(change.after),
                                 difference(change.before, change.after));
  if (change.largest && change.largest->x != change.before.at) text += ", " + largest_text(*change.largest);
  return text;
}

}  // namespace mpmvv::cli
