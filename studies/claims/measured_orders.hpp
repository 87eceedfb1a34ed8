#pragma once
#include "studies/claims/measured.hpp"

namespace mpmvv::claims {

/// Measures the order of a series. An unstable point has not converged: with it every lower bound fails, and an upper
/// bound is judged by the other points. Fewer than three of them have no interval without replicates, so they decide
/// nothing; a window that has no more points by design is judged by what it has.
void measure_order(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                   Measured& out);

/// Measures the difference of two orders as the order of the quotient of the two norms: its interval takes into account
/// that both norms are of the same runs. An unstable point has neither order, so with one the criterion cannot be
/// judged.
void measure_order_difference(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                              Measured& out);

}  // namespace mpmvv::claims
