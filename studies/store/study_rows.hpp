#pragma once
#include <optional>
#include <string>
#include <vector>

#include "studies/records/result.hpp"
#include "studies/store/database.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::store {

/// A study as its rows hold it.
struct StoredStudy {
  records::StudyResult result;
  std::vector<std::vector<std::string>> cases;  ///< by series and point: text of the case, empty where there is no run
  Provenance provenance;
};

/// Inserts a study, in the place of the one with this name and digest. A point that is a run takes its quantities from
/// the run, which must be there; only those in which the point differs are kept as its own.
void insert_study(Database& database, const StoredStudy& study);

/// Studies of this digest, in name order.
std::vector<StoredStudy> load_studies(const Database& database, const std::string& digest);

/// The code that ran the series of this row; none: our own solver, or a check.
std::optional<records::OtherCode> other_code(const Row& series);

/// Copies the studies that `to` lacks; their runs must be there.
void copy_studies(const Database& from, Database& to);

}  // namespace mpmvv::store
