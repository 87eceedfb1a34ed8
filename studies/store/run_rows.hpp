#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "studies/records/record.hpp"
#include "studies/store/database.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::store {

/// The id of the row for this build and processor, made when it is not there.
std::int64_t provenance_id(Database& database, const Provenance& p);

/// Reads it from a row with the columns of `provenance` and `kept_at`.
Provenance read_provenance(const Row& row);

/// Keeps a run unless its key is there. A `failed` run gives way to one that was carried out and to a later failure;
/// only a failure of the case does not give way to one of the machine. A sound run gives way to one that was timed
/// later, with others; one that was timed also to one that is not sound any more, unless the machine failed it.
void insert_run(Database& database, const records::Record& r, const Provenance& p);

/// The same with a row's columns; returns 1 when it was kept, else 0.
std::int64_t insert_run_row(Database& database, const Columns& columns, const Value& case_text, const Value& digest);

/// The run of this case by the program with this digest; nullopt without one. UsageError when its row is damaged.
std::optional<records::Record> find_run(const Database& database, const cases::Case& c, const std::string& digest);

/// What a row of `runs` gives to a point of a series: the errors that were measured, cost, energy, size.
std::map<std::string, double> run_quantities(const Row& row);

/// What the run cost in each round.
fits::Rounds rounds_of(const Row& row);

/// Copies the runs that `to` lacks, and those that say more than a failed run there; returns their number.
std::int64_t copy_runs(const Database& from, Database& to);

}  // namespace mpmvv::store
