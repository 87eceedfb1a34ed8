#pragma once
#include <string>

#include "studies/provenance.hpp"
#include "studies/result.hpp"

namespace mpmvv {

/// A golden file for review, with bands as in DESIGN.md: the fitted orders, the errors at the finest stable level in
/// the fitted norms, the limits and the check values. What cannot be proposed stands in a comment with the reason.
/// UsageError when the results come from a dirty tree or hold nothing to propose.
std::string propose_goldens(const StudyResult& study, const Provenance& provenance);

}  // namespace mpmvv
