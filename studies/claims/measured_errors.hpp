#pragma once
#include "studies/claims/measured.hpp"

namespace mpmvv::claims {

/// Measures the norm at every swept value in the window: the mean of replicates with Student's 95 % interval.
void measure_errors(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                    Measured& out);

/// Measures these norms over those of `over`; replicates are divided one by one. The ratio of two unstable runs is 1: W
/// gives each of them the same error, one.
void measure_ratios(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                    const records::Series& over, Measured& out);

/// Measures the largest over the smallest norm in the window; with replicates between the quotients of the ends of
/// their intervals. An unstable run makes the spread infinite. Where all are unstable, this does not show how far apart
/// they lie, so a lower bound alone cannot be judged.
void measure_spread(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                    Measured& out);

}  // namespace mpmvv::claims
