#include "studies/store/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <type_traits>

#include "studies/support/error.hpp"

namespace mpmvv::store {

using support::UsageError;

namespace {

int bind(sqlite3_stmt* statement, int index, const Value& value) {
  return std::visit(
      [&](const auto& held) {
        using Held = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::monostate>)
          return sqlite3_bind_null(statement, index);
        else if constexpr (std::is_same_v<Held, std::int64_t>)
          return sqlite3_bind_int64(statement, index, held);
        else if constexpr (std::is_same_v<Held, double>)
          return sqlite3_bind_double(statement, index, held);
        else
          return sqlite3_bind_text64(statement, index, held.data(), held.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
      },
      value.held());
}

Value column(sqlite3_stmt* statement, int index) {
  switch (sqlite3_column_type(statement, index)) {
    case SQLITE_INTEGER:
      return std::int64_t{sqlite3_column_int64(statement, index)};
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement, index);
    case SQLITE_NULL:
      return {};
    case SQLITE_TEXT: {
      const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, index));
      return std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, index)));
    }
    default:
      throw WrongKind();  // no column holds bytes
  }
}

std::vector<std::string> column_names(sqlite3_stmt* statement) {
  std::vector<std::string> names;
  for (int i = 0; i < sqlite3_column_count(statement); ++i) names.emplace_back(sqlite3_column_name(statement, i));
  return names;
}

}  // namespace

Value::Value(double number) {
  if (std::isfinite(number)) held_ = number;
}

double Value::real() const {
  if (null()) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* whole = std::get_if<std::int64_t>(&held_)) return static_cast<double>(*whole);
  return as<double>();
}

std::string Value::to_string() const {
  if (null()) return {};
  if (const auto* number = std::get_if<double>(&held_)) return fmt::format("{:.17g}", *number);
  if (const auto* whole = std::get_if<std::int64_t>(&held_)) return fmt::format("{}", *whole);
  return text();
}

const Value& Row::operator[](std::string_view name) const {
  const auto it = std::find(names_->begin(), names_->end(), name);
  if (it == names_->end()) throw std::logic_error(fmt::format("no column '{}' in the answer", name));
  return values_[static_cast<std::size_t>(it - names_->begin())];
}

void Database::Closer::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

Database::Database(std::filesystem::path file, Access access) : file_(std::move(file)) {
  // Access::read opens for writing, too: SQLite may have to undo what a killed process has left half-done, and
  // `query_only` keeps all other writes out. A file that may not be written SQLite opens for reading only.
  const int flags = SQLITE_OPEN_READWRITE |
                    (access == Access::create || access == Access::in_memory ? SQLITE_OPEN_CREATE : 0) |
                    (access == Access::in_memory ? SQLITE_OPEN_MEMORY : 0);
  sqlite3* raw = nullptr;
  std::error_code failed;
  const std::filesystem::path place = std::filesystem::absolute(file_, failed);
  if (failed)
    throw UsageError(fmt::format("results store '{}' cannot be opened ({})", file_.string(), failed.message()));
  const int code = sqlite3_open_v2(place.c_str(), &raw, flags, nullptr);
  connection_.reset(raw);
  require(code);
  sqlite3_extended_result_codes(raw, 1);
  wait_with({});
  sqlite3_busy_handler(raw, wait_on, wait_.get());
  // FULL: with a rollback journal NORMAL can corrupt the file when the power fails, and saves only one of four syncs.
  execute("PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL");
  if (access == Access::read) execute("PRAGMA query_only = ON");
}

void Database::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Database::wait_with(Patience patience) {
  constexpr double most = 10;  // s
  wait_->patience = patience ? std::move(patience) : [](double seconds) { return seconds < most; };
}

int Database::wait_on(void* wait, int waits) try {
  constexpr int moment = 10;  // ms
  auto& [patience, since] = *static_cast<Wait*>(wait);
  const auto now = std::chrono::steady_clock::now();
  if (waits == 0) since = now;
  if (!patience(std::chrono::duration<double>(now - since).count())) return 0;
  sqlite3_sleep(moment);
  return 1;
} catch (...) {  // no exception may pass through SQLite
  return 0;
}

bool Database::writable() const {
  return sqlite3_db_readonly(connection_.get(), "main") == 0;
}

bool Database::in_transaction() const {
  return sqlite3_get_autocommit(connection_.get()) == 0;
}

void Database::execute(const std::string& statements) {
  require(sqlite3_exec(connection_.get(), statements.c_str(), nullptr, nullptr, nullptr));
}

std::int64_t Database::change(const std::string& statement, const Values& values) {
  each(statement, values, [](const Row&) {});
  return sqlite3_changes64(connection_.get());
}

std::int64_t Database::insert(const std::string& table, const Columns& columns, const std::string& conflict) {
  std::string names, marks;
  Values values;
  for (const auto& [name, value] : columns) {
    names += (names.empty() ? "" : ", ") + name;
    marks += marks.empty() ? "?" : ", ?";
    values.push_back(value);
  }
  return change(fmt::format("INSERT INTO {} ({}) VALUES ({}) {}", table, names, marks, conflict), values);
}

std::int64_t Database::last_row_id() const {
  return sqlite3_last_insert_rowid(connection_.get());
}

std::int64_t Database::bytes() const {
  return scalar("SELECT page_count * page_size FROM pragma_page_count, pragma_page_size").integer();
}

Database::Statement Database::prepared(const std::string& text) const {
  if (auto idle = idle_.extract(text)) return std::move(idle.mapped());
  sqlite3_stmt* raw = nullptr;
  require(sqlite3_prepare_v2(connection_.get(), text.c_str(), -1, &raw, nullptr));
  return Statement(raw);
}

void Database::each(const std::string& query, const Values& values,
                    const std::function<void(const Row&)>& visit) const {
  Statement statement = prepared(query);
  for (std::size_t i = 0; i < values.size(); ++i) require(bind(statement.get(), static_cast<int>(i) + 1, values[i]));
  std::vector<std::string> names;
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(statement.get())) == SQLITE_ROW) {
    if (names.empty()) names = column_names(statement.get());  // tables may have changed since it was prepared
    try {
      Values row;
      row.reserve(names.size());
      for (int i = 0; i < static_cast<int>(names.size()); ++i) row.push_back(column(statement.get(), i));
      visit(Row(names, std::move(row)));
    } catch (const WrongKind&) {
      fail_damaged("a value is of another kind than its column's");
    }
  }
  if (code != SQLITE_DONE) fail(code);
  sqlite3_reset(statement.get());
  idle_.insert_or_assign(query, std::move(statement));
}

std::vector<std::string> Database::columns(const std::string& query) const {
  return column_names(prepared(query).get());
}

Value Database::scalar(const std::string& query, const Values& values) const {
  std::optional<Value> first;
  each(query, values, [&](const Row& row) {
    if (!first) first = row.values().front();
  });
  return first.value_or(Value());
}

void Database::fail_damaged(const std::string& what) const {
  throw UsageError(
      fmt::format("results store '{}' is damaged: {} (restore a copy, or start a new store)", file_.string(), what));
}

void Database::require(int code) const {
  if (code != SQLITE_OK) fail(code);
}

void Database::fail(int code) const {
  const std::string name = fmt::format("results store '{}'", file_.string());
  const std::string cause = sqlite3_errmsg(connection_.get());
  if (code == SQLITE_READONLY_ROLLBACK)
    throw UsageError(fmt::format("{} holds a write that was interrupted (open it once where it can be written)", name));
  if (code == SQLITE_READONLY_DBMOVED)
    throw UsageError(fmt::format("{} was moved or removed while it was open (leave it in its place)", name));
  switch (code & 0xff) {
    case SQLITE_NOTADB:
      throw UsageError(fmt::format("'{}' is not a results store: no SQLite file (name another file)", file_.string()));
    case SQLITE_CORRUPT:
      fail_damaged("its pages do not fit together, as where it was cut off");
    case SQLITE_FULL:
      throw UsageError(fmt::format("no space left to write {} (free some; what it held before is intact)", name));
    case SQLITE_BUSY:
      throw UsageError(fmt::format("{} is locked by another process (wait for it to end)", name));
    case SQLITE_READONLY:
      throw UsageError(fmt::format("{} is read-only (make it and its folder writable, or name another file)", name));
    case SQLITE_CANTOPEN:
      throw UsageError(fmt::format("{} cannot be opened (check the permissions of it and its folder)", name));
    case SQLITE_IOERR:
      throw UsageError(fmt::format("{}: {} (check the disk and its quota)", name, cause));
    default:
      throw UsageError(fmt::format("{}: {} (see `mpmvv db check`)", name, cause));
  }
}

Transaction::Transaction(Database& database, Kind kind) : database_(database) {
  database_.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

void Transaction::commit() {
  database_.execute("COMMIT");
}

void Transaction::roll_back() noexcept {
  if (!database_.in_transaction()) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const UsageError&) {  // the next opening rolls back
  }
}

}  // namespace mpmvv::store
