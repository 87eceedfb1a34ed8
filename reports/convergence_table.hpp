#pragma once
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// The errors of a study and their orders in LaTeX, for a paper: a table for each norm that it fits or draws, swept
/// values down and series across, four abreast with their orders, others below. Under the errors stand the fitted
/// orders with their windows. It fits into 125 mm. Series of more than forty points are left out. Empty where there are
/// no errors.
std::string latex_convergence_tables(const records::StudyResult& study);

}  // namespace mpmvv::reports
