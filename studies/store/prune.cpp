#include <algorithm>
#include <set>

#include "studies/store/schema.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::store {

namespace {

std::int64_t bytes_of(const Database& database) {
  return database.scalar("SELECT page_count * page_size FROM pragma_page_count, pragma_page_size").integer();
}

std::set<std::string> digests_in(const Database& database) {
  std::set<std::string> digests;
  database.each("SELECT digest FROM provenance", {}, [&](const Row& row) { digests.insert(row["digest"].text()); });
  return digests;
}

}  // namespace

Store::Pruned Store::prune(const std::filesystem::path& file, std::size_t newest, const std::string& running_digest) {
  Pruned pruned{.versions = Store(file, Mode::write).versions(), .studies = 0, .records = 0, .bytes = 0};
  Database database = open_store(file, Mode::write);
  const std::int64_t bytes = bytes_of(database);
  std::set<std::string> old = digests_in(database);
  old.erase(running_digest);
  const std::size_t first_kept = pruned.versions.size() - std::min(newest, pruned.versions.size());
  for (std::size_t v = first_kept; v < pruned.versions.size(); ++v) old.erase(pruned.versions[v].digest);
  std::erase_if(pruned.versions, [&](const Version& version) { return !old.contains(version.digest); });

  Transaction transaction(database, Transaction::Kind::write);
  // SQLite looks for the points of each run that it removes: without the index, among all points.
  database.execute("CREATE INDEX points_by_run ON points (run)");
  for (const std::string& digest : old) {
    pruned.studies += database.change("DELETE FROM studies WHERE digest = ? AND codes IS NULL", {digest});
    pruned.records += database.change(
        "DELETE FROM runs WHERE digest = ? AND NOT EXISTS (SELECT 1 FROM points WHERE run = runs.id)", {digest});
  }
  database.execute(
      "DROP INDEX points_by_run; DELETE FROM provenance WHERE id NOT IN "
      "(SELECT provenance FROM runs UNION ALL SELECT provenance FROM studies)");
  transaction.commit();
  database.execute("VACUUM");
  pruned.bytes = bytes - bytes_of(database);
  return pruned;
}

}  // namespace mpmvv::store
