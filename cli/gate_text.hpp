#pragma once
#include <string>
#include <vector>

#include "goldens/gate.hpp"
#include "studies/store/code_series.hpp"

namespace mpmvv::cli {

/// A version of another code, by a series of each study that it ran.
struct JudgedCode {
  store::CodeSeries ran;
  bool shares_version;  ///< whether the store has several programs of this version
};

/// The other codes that ran studies.
struct GatedCodes {
  std::vector<JudgedCode> judged;           ///< of studies that have goldens
  std::vector<std::string> without_golden;  ///< further studies that a code ran
};

/// Prints what fails, then what is inconclusive, what the store has nothing of in one line, and how many there are of
/// each; with `verbose` also what passes, and each golden that the store has nothing of.
void print_gate(const goldens::GateReport& report, const GatedCodes& codes, bool verbose);

}  // namespace mpmvv::cli
