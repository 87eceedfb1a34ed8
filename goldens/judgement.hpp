#pragma once
#include <optional>
#include <string>

#include "goldens/golden.hpp"
#include "goldens/lost_runs.hpp"
#include "studies/records/result.hpp"
#include "studies/records/verdict.hpp"

namespace mpmvv::goldens {

using records::Verdict;

/// What a gate finds of one golden.
struct Judgement {
  Verdict verdict = Verdict::inconclusive;
  std::string measured;    ///< empty where nothing was
  std::string reason;      ///< empty for `pass`
  bool better = false;     ///< it fails because the result improved
  std::string cause = {};  ///< with which `reason` ends: what a run says that is not ok; may be empty
};

Judgement pass(std::string measured);
Judgement fail(std::string measured, std::string reason);
Judgement fail_as_better(std::string measured, std::string reason);
Judgement fail(std::string measured, const LostRuns& lost);
Judgement inconclusive(std::string measured, std::string reason);
Judgement missing(const std::string& what);

/// The point of a series at a swept value, up to round-off; nullptr when there is none.
const records::Point* find_point(const records::Series& series, double at);

std::string status_text(const records::Point& point);

/// Why there is no error at a level that a golden names, with nothing measured; nullopt where there is one.
std::optional<Judgement> lacking(const records::Series& series, const std::string& norm, double at);

Judgement judge(const OrderGolden& golden, const records::Series& series);

}  // namespace mpmvv::goldens
