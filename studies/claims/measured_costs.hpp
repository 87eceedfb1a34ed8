#pragma once
#include "studies/claims/measured.hpp"

/// Measures of what runs cost. What is computed from times that were measured in the same rounds has the interval of
/// these rounds (paired_rounds.hpp). Else a time has the range of its repetitions (`step_seconds_spread`), and what is
/// computed from it an interval, by half of these ranges. A slope of replicated errors has one by the intervals of
/// their means; no other number has any.
namespace mpmvv::claims {

/// The slope of a series over that of `over`, or over the first value of it.
void measure_slope(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                   const records::Series& over, Measured& out);

/// A series that never gets down to an error costs infinitely much there, whatever the other one does. Where neither
/// gets there, this does not show how much more it costs, so a lower bound alone cannot be judged. All runs of a series
/// make its cost curve: where one of them failed, nothing is judged, and how much an error costs that the others do not
/// reach is not known.
void measure_cost_ratios(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                         const records::Series& over, Measured& out);

}  // namespace mpmvv::claims
