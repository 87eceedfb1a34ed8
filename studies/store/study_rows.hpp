#pragma once
#include <limits>
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
  std::string codes;                            ///< the lines of the codes that ran some of these (code_versions.hpp)
  Provenance provenance;
};

/// Stands for infinity in the value of a check, with its sign: a value that is not measured is NULL.
inline constexpr double for_infinity = std::numeric_limits<double>::max();

/// Inserts a study of a name, digest and codes that are not there yet. A point that is a run takes its quantities from
/// the run, which must be there; only those in which the point differs are kept as its own.
void insert_study(Database& database, const StoredStudy& study);

/// The same, in place of the study with this name, digest and codes, and of one with this name and digest whose codes
/// are not known.
void replace_study(Database& database, const StoredStudy& study);

/// Studies of this digest, in name order. Of a study that several versions of a code ran, only the one kept last.
std::vector<StoredStudy> load_studies(const Database& database, const std::string& digest);

/// Studies that this version of a code ran, whatever the digest, in name order; of each the last one kept that is no
/// trial.
std::vector<StoredStudy> load_studies_of_code(const Database& database, const std::string& line);

/// A condition on rows of `studies`: none of the same name and digest was kept later.
inline constexpr const char* is_newest =
    "studies.id IN (SELECT id FROM (SELECT id, row_number() OVER "
    "(PARTITION BY name, digest ORDER BY kept_at DESC, id DESC) AS place FROM studies NOT INDEXED) WHERE place = 1)";

/// The code that ran the series of this row; none: our own solver, or a check.
std::optional<records::OtherCode> other_code(const Row& series);

/// Copies the studies that `to` lacks or has only from an earlier time, in their order; their runs must be there.
void copy_studies(const Database& from, Database& to);

}  // namespace mpmvv::store
