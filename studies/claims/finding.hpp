#pragma once
#include <array>
#include <string>
#include <vector>

#include "studies/fits/window.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::claims {

using support::not_measured;
using support::to_string;

/// One result of a study under a name, so that versions can be laid side by side.
struct Finding {
  enum class Kind { order, error, limit, value, status, cost, verdict };

  /// A point of an error or of a curve.
  struct Level {
    double x = 0, y = 0;
  };

  std::string study = {};  ///< empty for the verdict of a claim
  Kind kind = Kind::value;
  std::string name = {};                 ///< "order of 'linear' in l2 over [16, 128]"; differs within a study
  double number = not_measured;          ///< of an error or a cost: that of the finest level
  std::string word = {};                 ///< a status, a verdict, why there is no number; else empty
  int better = 0;                        ///< 1: the larger the better; -1: the smaller; 0: neither
  std::vector<Level> levels = {};        ///< of an error or curve, in increasing x
  double at = not_measured;              ///< of an error: the swept value of the finest level; of a status: its run's
  double uncertainty = not_measured;     ///< of an extrapolated value
  std::string quantity = {};             ///< of an error, a curve, a limit or an extrapolated value: l2, cfl
  std::string series = {};               ///< of an order, error or status
  fits::Window window = {};              ///< of an order
  bool monotone = true;                  ///< of a limit: false where a stable value lies beyond an unstable one
  std::vector<std::string> judges = {};  ///< of the verdict on a claim: the studies that have criteria of it
  int side = 0;  ///< of a limit that was not found: 1 where all values tried are stable, -1 where none is, else 0
};

constexpr std::array<const char*, 7> words_of(Finding::Kind) {
  return {"order", "error", "limit", "value", "status", "cost", "verdict"};
}

/// The number with six digits, and where it was measured, how uncertain it is or that the limit is not monotone; or the
/// word.
std::string text(const Finding& finding);

/// Orders, errors in every norm that is fitted or drawn, curves, limits, values, extrapolated ones too, statuses, and
/// cost in ns per particle and step where it was measured alone (`repeat`).
std::vector<Finding> findings_of(const records::StudyResult& study);

/// The findings of all studies, the verdicts on their criteria, and those on the claims that they judge.
std::vector<Finding> findings_of(const std::vector<records::StudyResult>& studies);

}  // namespace mpmvv::claims
