#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// A criterion as it was judged, under a label: of a study's criteria the claim, of a claim's the study.
struct LabelledPart {
  std::string label;
  records::ClaimPart part;
};

std::string asked_text(const records::ClaimPart& part);  ///< "1.75 to 2.25"
std::string found_text(const records::ClaimPart& part);  ///< "1.97 ± 0.2", "1.97, unstable", of more their range

/// One number that was found: "1.97 ± 0.2", "unstable"; without an interval its remark, "inf ('a' never reaches it)";
/// "-" where it was not measured.
std::string found_text(const records::ClaimPart& part, const records::Found& found);

/// Prints a line for each criterion: label, verdict, what was asked and found, statement.
void print_criteria(const std::string& head, const std::vector<LabelledPart>& parts);

/// Prints the evidence of each criterion: every number that it compared, with its interval, on a line of its own.
void print_grounds(const std::vector<LabelledPart>& parts);

/// Prints why criteria are inconclusive, except what their grounds say already where these have been printed.
void print_undecided(const std::vector<LabelledPart>& parts, bool have_grounds);

/// Prints why criteria fail, as far as the studies say.
void print_reasons(const std::vector<LabelledPart>& parts);

}  // namespace mpmvv::cli
