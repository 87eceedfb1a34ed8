#pragma once
#include <optional>
#include <string>
#include <vector>

#include "studies/claims/finding.hpp"

namespace mpmvv::goldens {

/// Two numbers that differ by no more than this are the same up to round-off: |a - b| <= relative max(|a|, |b|), or
/// both are at most `absolute` in size.
inline constexpr double relative_round_off = 1e-9, absolute_round_off = 1e-13;

/// Whether it is a check's curve, which has levels and neither a number nor a verdict of its own.
bool is_curve(const claims::Finding& finding);

/// One finding in both versions.
struct Change {
  /// The level at which an error or a curve changed most.
  struct AtLevel {
    double x = 0, before = 0, after = 0;
  };

  claims::Finding before, after;
  std::optional<AtLevel> largest;  ///< when any level changed
  double bands = 0;                ///< in widths of the goldens' bands; negative: better; positive: worse, or neither
};

/// What differs between the findings of two versions.
struct Comparison {
  std::vector<Change> changes;                       ///< of all findings but cost, worst first, unchanged ones too
  std::vector<Change> costs;                         ///< largest ratio first; never judged
  std::vector<std::string> only_before, only_after;  ///< studies, and findings of studies that both have

  std::size_t changed() const;
};

/// Compares the findings of the same study and name; of several, the first with the first, and so on. Findings that
/// only one side has are listed in `only_before` and `only_after`. So is the verdict on a claim that other studies
/// judge on the other side, with the studies that judge it.
Comparison compare(const std::vector<claims::Finding>& before, const std::vector<claims::Finding>& after);

}  // namespace mpmvv::goldens
