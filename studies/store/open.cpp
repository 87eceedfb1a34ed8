#include <fmt/ranges.h>

#include <array>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

#include "studies/store/schema.hpp"
#include "studies/store/seal.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::store {

using support::UsageError;

namespace {

namespace fs = std::filesystem;
using Work = std::function<void(Database&)>;

/// UsageError for a file that is no store of ours. It reads the first bytes itself, so that SQLite never touches such a
/// file.
void require_ours(const fs::path& file) {
  constexpr std::string_view magic{"SQLite format 3\0", 16};
  constexpr std::size_t id_at = 68;
  std::array<char, 100> bytes{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw UsageError(fmt::format("results store '{}' cannot be read (check its permissions)", file.string()));
  stream.read(bytes.data(), bytes.size());
  if (stream.gcount() == 0) return;
  if (std::string_view(bytes.data(), magic.size()) != magic)
    throw UsageError(fmt::format("'{}' is not a results store: no SQLite file (name another file)", file.string()));
  std::int64_t id = 0;
  for (std::size_t i = 0; i < 4; ++i) id = id * 256 + static_cast<unsigned char>(bytes[id_at + i]);
  if (id != application_id)
    throw UsageError(fmt::format("'{}' is another application's SQLite file, not a results store (name another file)",
                                 file.string()));
}

void require_place(const fs::path& file, bool create) {
  std::error_code ignored;
  if (file.empty()) throw UsageError("no name given for the results store (for instance results.db)");
  std::error_code failed;
  const bool is_there = fs::exists(file, failed);
  if (failed)
    throw UsageError(fmt::format("results store '{}' cannot be used: {} (a file that can be reached)", file.string(),
                                 failed.message()));
  if (is_there) {
    if (!fs::is_regular_file(file, ignored))
      throw UsageError(fmt::format("results store '{}' is not a file (name a file)", file.string()));
    require_ours(file);
  } else if (!create) {
    throw UsageError(fmt::format("no results store '{}' (`mpmvv study` makes one)", file.string()));
  } else if (const fs::path folder = fs::absolute(file, ignored).parent_path(); !fs::is_directory(folder, ignored)) {
    throw UsageError(
        fmt::format("no folder '{}' for results store '{}' (make it first)", folder.string(), file.string()));
  }
}

using Steps = std::span<const char* const>;
using Tables = std::map<std::string, std::string>;  ///< by name: the statement that makes it; indexes and triggers, too

Tables tables_of(const Database& database) {
  Tables tables;
  database.each("SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL", {},
                [&](const Row& row) { tables[row["name"].text()] = row["sql"].text(); });
  return tables;
}

Tables make_tables(const fs::path& file, Steps steps) {
  Database database(file, Database::Access::in_memory);
  for (const char* step : steps) database.execute(step);
  return tables_of(database);
}

/// The tables that these steps lead to. They are made once and kept, because making them takes longer than the rest of
/// opening a store.
const Tables& tables_after(const fs::path& file, Steps steps) {
  static std::mutex mutex;
  static std::map<std::string, Tables> kept;
  const std::string statements = fmt::format("{}", fmt::join(steps, ";"));
  const std::lock_guard lock(mutex);
  auto found = kept.find(statements);
  if (found == kept.end()) found = kept.emplace(statements, make_tables(file, steps)).first;
  return found->second;
}

/// Throws unless the file has the tables of its schema. Tables that others have put beside them are ignored.
void require_tables(const Database& database, std::int64_t schema, Steps steps) {
  const Tables& wanted = tables_after(database.file(), steps.first(static_cast<std::size_t>(schema)));
  const Tables& newest = tables_after(database.file(), steps);
  Tables found = tables_of(database);
  std::erase_if(found, [&](const auto& t) { return !wanted.contains(t.first) && !newest.contains(t.first); });
  for (const auto& [name, sql] : wanted)
    if (!found.contains(name)) database.fail_damaged(fmt::format("table '{}' is missing", name));
  for (const auto& [name, sql] : found)
    if (!wanted.contains(name) || wanted.at(name) != sql)
      database.fail_damaged(fmt::format("table '{}' is not that of schema {}", name, schema));
}

/// The schema of the file, 0 while it is empty; UsageError when it is newer than this program or impossible.
std::int64_t read_schema(const Database& database, Steps steps) {
  const std::int64_t schema = database.scalar("PRAGMA user_version").integer();
  if (schema > std::ssize(steps))
    throw UsageError(
        fmt::format("results store '{}' has schema {}, made by a newer mpmvv; this one knows {} (use the "
                    "newer program or name another file)",
                    database.file().string(), schema, steps.size()));
  if (schema < 0) database.fail_damaged(fmt::format("there is no schema {}", schema));
  require_tables(database, schema, steps);
  return schema;
}

[[noreturn]] void fail_empty(const fs::path& file) {
  throw UsageError(fmt::format("'{}' is empty, not a results store (`mpmvv study` makes one)", file.string()));
}

Database open_for_reading(const fs::path& file, Steps steps, bool is_older_allowed) {
  Database database(file, Database::Access::read);
  const Transaction one_state(database, Transaction::Kind::read);
  const std::int64_t schema = read_schema(database, steps);
  if (schema == 0) fail_empty(file);
  if (schema < std::ssize(steps) && !is_older_allowed)
    throw UsageError(
        fmt::format("results store '{}' has the older schema {}, this mpmvv reads {} (`mpmvv db update` "
                    "brings it up to date)",
                    file.string(), schema, steps.size()));
  return database;
}

/// Restores the indexes and triggers of others (all but `ours`) that were lost with a table that a step has rebuilt.
void restore_others(Database& database, const Tables& before, const Tables& ours) {
  const Tables after = tables_of(database);
  for (const auto& [name, sql] : before)
    if (!after.contains(name) && !ours.contains(name)) database.execute(sql);
}

/// Applies the steps that the file lacks; false when it lacks none. It sets the version even then: this write shows,
/// before any work is done, whether folder and disk take a journal.
bool apply_missing(Database& database, bool create, Steps steps) {
  const std::int64_t schema = read_schema(database, steps);
  if (schema == 0 && !create) fail_empty(database.file());
  if (std::error_code ignored; schema == 0 && !fs::exists(database.file(), ignored))
    throw UsageError(
        fmt::format("results store '{}' was removed while it was opened (try again)", database.file().string()));
  if (schema == 0) database.execute(fmt::format("PRAGMA application_id = {}", application_id));
  if (schema > 0 && schema < std::ssize(steps) && database.scalar("PRAGMA foreign_keys").flag())
    throw UsageError(fmt::format("results store '{}' was made by an older mpmvv while it was opened (try again)",
                                 database.file().string()));
  const Tables before = tables_of(database);
  for (const char* step : steps.subspan(static_cast<std::size_t>(schema))) database.execute(step);
  restore_others(database, before, tables_after(database.file(), steps.first(static_cast<std::size_t>(schema))));
  if (schema < first_sealed_schema && first_sealed_schema <= std::ssize(steps)) seal_all(database);
  database.execute(fmt::format("PRAGMA user_version = {}", steps.size()));
  return schema < std::ssize(steps);
}

/// Applies the steps and the work under the write lock: of two processes that create a store at once, the second finds
/// it done. A file that was just made (`fresh`) and cannot be filled is removed again.
void migrate(Database& database, bool create, bool fresh, Steps steps, const Work& work) {
  Transaction transaction(database, Transaction::Kind::write);
  try {
    const bool migrated = apply_missing(database, create, steps);
    if (work) work(database);
    if (migrated || work) transaction.commit();
  } catch (...) {
    transaction.roll_back();
    const fs::path& file = database.file();
    if (std::error_code ignored; fresh && fs::file_size(file, ignored) == 0) fs::remove(file, ignored);
    throw;
  }
}

/// Whether the file holds tables of an older schema. Its migration needs foreign keys off and legacy_alter_table on:
/// when a step rebuilds a table, dropping the old one would otherwise delete the rows that refer to it, and views that
/// others have made of it would have to be valid at every moment.
bool is_older(const Database& database, Steps steps) {
  const std::int64_t schema = database.scalar("PRAGMA user_version").integer();
  return schema > 0 && schema < std::ssize(steps);
}

Database open_for_writing(const fs::path& file, bool create, Steps steps, const Work& work) {
  std::error_code ignored;
  const bool fresh = !fs::exists(file, ignored);
  Database database(file, create ? Database::Access::create : Database::Access::write);
  if (!database.writable())
    throw UsageError(fmt::format(
        "results store '{}' is read-only (make it and its folder writable, or name another file)", file.string()));
  if (is_older(database, steps)) {
    database.execute("PRAGMA foreign_keys = OFF; PRAGMA legacy_alter_table = ON");  // no effect in a transaction
    migrate(database, create, fresh, steps, {});
    database.execute("PRAGMA foreign_keys = ON; PRAGMA legacy_alter_table = OFF");
  }
  migrate(database, create, fresh, steps, work);
  return database;
}

}  // namespace

void require_place(const fs::path& file) {
  require_place(file, true);
}

Database open_store(const fs::path& file, Store::Mode mode, Steps steps, const Work& work) {
  const bool create = mode == Store::Mode::create_or_write;
  require_place(file, create);
  if (mode == Store::Mode::read) return open_for_reading(file, steps, false);
  return open_for_writing(file, create, steps, work);
}

Database open_older_store(const fs::path& file) {
  require_place(file, false);
  return open_for_reading(file, migrations(), true);
}

}  // namespace mpmvv::store
