#pragma once
#include <map>
#include <string>

#include "studies/result.hpp"

namespace mpmvv {

/// File name -> content: STUDY.csv (points) and, where there are any, STUDY-fits.csv, STUDY-limits.csv,
/// STUDY-probes.csv, STUDY-values.csv. Numbers have 17 digits, NaN is empty.
std::map<std::string, std::string> csv_tables(const StudyResult& study);

}  // namespace mpmvv
