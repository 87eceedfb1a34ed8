#pragma once
#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// Prints what a study measured at its swept values: a table for each quantity with a column for each series, or, where
/// the series have other values, a table for each series with a column for each quantity.
void print_errors(const records::StudyResult& study);

}  // namespace mpmvv::cli
