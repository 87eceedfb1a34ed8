#include <algorithm>
#include <set>

#include "studies/store/program_versions.hpp"
#include "studies/store/schema.hpp"
#include "studies/store/store.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::store {

namespace {

/// Of a row of `studies`: no other code ran any of it.
constexpr const char* is_own = "NOT EXISTS (SELECT 1 FROM series WHERE study = studies.id AND code IS NOT NULL)";

/// The versions that go: of those that kept own studies all but the newest and the running program's.
std::vector<Version> old_versions(const Database& database, std::size_t newest, const std::string& running_digest) {
  std::set<std::string> with_own;
  database.each(std::string("SELECT DISTINCT digest FROM studies WHERE ") + is_own, {},
                [&](const Row& row) { with_own.insert(row["digest"].text()); });
  std::vector<Version> versions = versions_of_program(database);
  std::erase_if(versions, [&](const Version& version) { return !with_own.contains(version.digest); });
  versions.resize(versions.size() - std::min(newest, versions.size()));
  std::erase_if(versions, [&](const Version& version) { return version.digest == running_digest; });
  return versions;
}

}  // namespace

Store::Pruned Store::prune(const std::filesystem::path& file, std::size_t newest, const std::string& running_digest) {
  Database database = open_store(file, Mode::write);
  const std::int64_t bytes = database.bytes();
  Pruned pruned;
  Transaction transaction(database, Transaction::Kind::write);
  pruned.versions = old_versions(database, newest, running_digest);
  // SQLite looks for the points of each run that it removes: without the index, among all points.
  database.execute("CREATE INDEX points_by_run_to_prune ON points (run)");
  for (const Version& version : pruned.versions) {
    pruned.studies +=
        database.change(std::string("DELETE FROM studies WHERE digest = ? AND ") + is_own, {version.digest});
    pruned.records += database.change(
        "DELETE FROM runs WHERE digest = ? AND instr(case_text, ' code=') = 0 AND "
        "NOT EXISTS (SELECT 1 FROM points WHERE run = runs.id)",
        {version.digest});
  }
  database.execute(
      "DROP INDEX points_by_run_to_prune; DELETE FROM provenance WHERE id NOT IN "
      "(SELECT provenance FROM runs UNION ALL SELECT provenance FROM studies)");
  transaction.commit();
  try {
    database.execute("VACUUM");
  } catch (const support::UsageError& e) {
    pruned.why_not_smaller = e.what();
  }
  pruned.bytes = bytes - database.bytes();
  return pruned;
}

}  // namespace mpmvv::store
