#pragma once
#include <map>
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// File name -> content: STUDY.csv (points, behind a fitted quantity its order from the point before) and, where there
/// are any, fits/STUDY.csv, replicates/, extrapolations/, limits/, probes/ and values/STUDY.csv: a folder for each, so
/// that no two studies share a file, whatever their names. Numbers have 17 digits, NaN is empty.
std::map<std::string, std::string> csv_tables(const records::StudyResult& study);

}  // namespace mpmvv::reports
