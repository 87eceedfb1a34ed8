#pragma once
#include <set>
#include <string>
#include <vector>

#include "goldens/golden.hpp"
#include "studies/records/result.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::goldens {

/// A golden file for review, with the bands of golden.hpp: the fitted orders, the errors at the finest stable level in
/// the fitted norms, the limits and the check values. What cannot be proposed stands in a comment with the reason, and
/// so do the `planted` series: whether a planted mistake is worse or better than before says nothing of the code.
/// UsageError when the results were made with `study --set`, hold nothing to propose, or fail one of the `standing`
/// goldens: a worse result takes a golden's place only after that golden is deleted.
std::string propose_goldens(const records::StudyResult& study, const store::Provenance& provenance,
                            const std::vector<Golden>& standing = {}, const std::set<std::string>& planted = {});

/// UsageError when the results come from a tree with changes that are not committed. Goldens of this project must be
/// reproducible from their commit; those of other folders are identified by the digest.
void require_committed(const records::StudyResult& study, const store::Provenance& provenance);

}  // namespace mpmvv::goldens
