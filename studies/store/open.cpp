#include <fmt/format.h>

#include <array>
#include <fstream>

#include "studies/error.hpp"
#include "studies/store/schema.hpp"

namespace mpmvv::db {

namespace {

namespace fs = std::filesystem;

/// A file that is no store of ours is found out by its first bytes, before SQLite touches it.
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
  if (fs::exists(file, ignored)) {
    if (!fs::is_regular_file(file, ignored))
      throw UsageError(fmt::format("results store '{}' is not a file (name a file)", file.string()));
    require_ours(file);
  } else if (!create) {
    throw UsageError(fmt::format("no results store '{}' (`mpmvv study` makes one)", file.string()));
  } else if (const fs::path folder = fs::absolute(file).parent_path(); !fs::is_directory(folder, ignored)) {
    throw UsageError(
        fmt::format("no folder '{}' for results store '{}' (make it first)", folder.string(), file.string()));
  }
}

/// The schema of the file, 0 while it is empty; UsageError when this program does not know it.
std::int64_t read_schema(const Database& database, std::int64_t newest) {
  const std::int64_t schema = database.scalar("PRAGMA user_version").integer();
  if (schema > newest)
    throw UsageError(
        fmt::format("results store '{}' has schema {}, made by a newer mpmvv; this one knows {} (use the "
                    "newer program or name another file)",
                    database.file().string(), schema, newest));
  return schema;
}

[[noreturn]] void fail_empty(const fs::path& file) {
  throw UsageError(fmt::format("'{}' is empty, not a results store (`mpmvv study` makes one)", file.string()));
}

Database open_for_reading(const fs::path& file, std::span<const char* const> steps) {
  Database database(file, Database::Access::read);
  const std::int64_t schema = read_schema(database, std::ssize(steps));
  if (schema == 0) fail_empty(file);
  if (schema < std::ssize(steps))
    throw UsageError(
        fmt::format("results store '{}' has the older schema {}, this mpmvv reads {} (`mpmvv study` "
                    "brings it up to date)",
                    file.string(), schema, steps.size()));
  return database;
}

/// Applies what the file lacks; false when that is nothing. Setting the version writes in any case, and so shows
/// whether folder and disk take a journal, before any work is done.
bool apply_missing(Database& database, bool create, std::span<const char* const> steps) {
  const std::int64_t schema = read_schema(database, std::ssize(steps));
  if (schema == 0 && !create) fail_empty(database.file());
  if (schema == 0 && !fs::exists(database.file()))
    throw UsageError(
        fmt::format("results store '{}' was removed while it was opened (try again)", database.file().string()));
  if (schema == 0) database.execute(fmt::format("PRAGMA application_id = {}", application_id));
  for (const char* step : steps.subspan(static_cast<std::size_t>(schema))) database.execute(step);
  database.execute(fmt::format("PRAGMA user_version = {}", steps.size()));
  return schema < std::ssize(steps);
}

/// Under the write lock: of two processes that create a store at once, the second finds it done. A file that was just
/// made (`fresh`) and cannot be filled goes away again.
void migrate(Database& database, bool create, bool fresh, std::span<const char* const> steps) {
  Transaction transaction(database, Transaction::Kind::write);
  try {
    if (apply_missing(database, create, steps)) transaction.commit();
  } catch (const UsageError&) {
    transaction.roll_back();
    const fs::path& file = database.file();
    if (std::error_code ignored; fresh && fs::file_size(file, ignored) == 0) fs::remove(file, ignored);
    throw;
  }
}

Database open_for_writing(const fs::path& file, bool create, std::span<const char* const> steps) {
  const bool fresh = !fs::exists(file);
  Database database(file, create ? Database::Access::create : Database::Access::write);
  if (!database.writable())
    throw UsageError(fmt::format(
        "results store '{}' is read-only (make it and its folder writable, or name another file)", file.string()));
  migrate(database, create, fresh, steps);
  return database;
}

}  // namespace

Database open_store(const fs::path& file, Store::Mode mode, std::span<const char* const> steps) {
  const bool create = mode == Store::Mode::create_or_write;
  require_place(file, create);
  if (mode == Store::Mode::read) return open_for_reading(file, steps);
  return open_for_writing(file, create, steps);
}

}  // namespace mpmvv::db
