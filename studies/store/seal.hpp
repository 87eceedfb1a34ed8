#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "studies/store/database.hpp"

namespace mpmvv::store {

/// A seal shows that something is as it was written, as SQLite has no checksums: the CRC-64 of a row and of the rows
/// that belong to it, ids included. NULL does not count, so a column that is added empty leaves every seal as it is.
enum class Sealed { run, study };

/// From this schema on every run and study has a seal.
inline constexpr std::int64_t first_sealed_schema = 8;

/// Seals what has just been written under this id.
void seal(Database& database, Sealed kind, std::int64_t id);

/// The seal of a run that has this row and this row of provenance, each with all its columns.
std::int64_t seal_of_run(const Row& run, const Row& provenance);

/// Seals all that a store holds.
void seal_all(Database& database);

/// UsageError when the row has no seal, or one that does not fit what it holds.
void require_intact(const Database& database, Sealed kind, const Value& id);

/// The same of a run whose row has been read already: all of its columns, and no others.
void require_intact_run(const Database& database, const Row& run);

/// The rows whose seal does not fit what they hold, in words for people. Other programs may write meanwhile: each row
/// is read in a transaction of its own, so that they wait for one row, not for all.
std::vector<std::string> broken_seals(Database& database);

}  // namespace mpmvv::store
