#include "cli/change_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mpmvv::cli {

using claims::Finding;

namespace {

/// The difference of two numbers as a text; empty where one is a word or they are errors at different levels.
std::string difference(const Finding& before, const Finding& after) {
  const double a = before.number, b = after.number;
  const bool same_level = before.at == after.at || std::isnan(before.at);
  if (!before.word.empty() || !after.word.empty() || !same_level) return "";
  if (before.kind == Finding::Kind::order || a == 0) return fmt::format(" ({:+.3g})", b - a);
  if (before.kind == Finding::Kind::cost) return fmt::format(" (x {:.3f})", b / a);
  return fmt::format(" ({:+.3g} %)", 100 * (b - a) / std::abs(a));
}

}  // namespace

std::string change_text(const goldens::Change& change) {
  std::string text = fmt::format("{}: {} -> {}{}", change.before.name, claims::text(change.before),
                                 claims::text(change.after), difference(change.before, change.after));
  if (change.largest && change.largest->x != change.before.at)
    text += fmt::format(", most at {:g}: {:.6g} -> {:.6g}", change.largest->x, change.largest->before,
                        change.largest->after);
  return text;
}

}  // namespace mpmvv::cli
