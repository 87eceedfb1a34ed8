#pragma once
#include "studies/claims/measured.hpp"

namespace mpmvv::claims {

/// The order of a series. An unstable point has not converged: with it no lower bound is kept, and an upper bound as
/// far as the others keep it.
void measure_order(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                   Measured& out);

/// The difference of two orders is the order of the quotient, whose interval knows that both are of the same runs. An
/// unstable point has neither order.
void measure_order_difference(const Criterion& c, const records::StudyResult& result, const records::Series& series,
                              Measured& out);

}  // namespace mpmvv::claims
