#pragma once
#include <map>
#include <string>
#include <vector>

#include "goldens/golden.hpp"
#include "studies/records/result.hpp"
#include "studies/records/verdict.hpp"

namespace mpmvv::goldens {

using records::Verdict;

/// One golden, judged.
struct GateResult {
  std::string study;
  std::string name;  ///< subject of the golden
  Verdict verdict = Verdict::inconclusive;
  std::string expected;
  std::string measured;    ///< empty where nothing was
  std::string reason;      ///< empty for `pass`
  std::string where = {};  ///< of the golden, FILE:LINE
  bool better = false;     ///< it failed because results improved: the golden should be renewed
  bool is_absent = false;  ///< the store has nothing of its study
  std::string cause = {};  ///< with which `reason` ends: what a run says that is not ok; of all goldens of that run
};

/// ", measured 2.01 (3 points)", and ", not measured" where a golden fails because nothing was; else empty.
std::string measured_text(const GateResult& result);

/// All goldens, judged, in their order.
struct GateReport {
  std::vector<GateResult> results;

  int count(Verdict v) const;
  int exit_code() const;  ///< 1 with any failure, else 3 with anything inconclusive, else 0
};

/// How results made with `study --set` are judged. Goldens are not of such runs, so they are inconclusive unless the
/// user asks to have them judged all the same (`gate --as-set`).
enum class Trials { inconclusive, judged };

/// What is judged.
struct GateScope {
  std::vector<std::string> only = {};  ///< the goldens of these studies; empty: of all
  Trials trials = Trials::inconclusive;
  std::map<std::string, std::string> outdated = {};  ///< studies that are inconclusive, and why they are too old
};

/// Holds the goldens against the stored studies. UsageError when there is nothing to judge or a name in `only` has no
/// golden.
GateReport run_gate(const std::vector<Golden>& goldens, const std::vector<records::StudyResult>& studies,
                    const GateScope& scope = {});

}  // namespace mpmvv::goldens
