#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace mpmvv::store {

/// A value is of another kind than its column's: the file is damaged. `Database::each` says which file.
struct WrongKind : std::runtime_error {
  WrongKind() : std::runtime_error("a value in a results store is of another kind than its column's") {}
};

/// What a column of a row holds. NaN and infinity are kept as NULL, and NULL read by real() is NaN. Reading it as
/// another type than it has throws WrongKind.
class Value {
 public:
  Value() = default;
  Value(bool flag) : held_(std::int64_t{flag}) {}
  Value(int number) : held_(std::int64_t{number}) {}
  Value(std::int64_t number) : held_(number) {}
  Value(std::size_t number) : held_(static_cast<std::int64_t>(number)) {}
  Value(double number);
  Value(std::optional<double> number) : Value(number ? Value(*number) : Value()) {}
  Value(std::string text) : held_(std::move(text)) {}
  Value(const char* text) : held_(std::string(text)) {}

  bool null() const { return std::holds_alternative<std::monostate>(held_); }
  std::int64_t integer() const { return as<std::int64_t>(); }
  bool flag() const { return integer() != 0; }
  const std::string& text() const { return as<std::string>(); }
  double real() const;
  std::optional<double> optional_real() const { return null() ? std::nullopt : std::optional(real()); }

  /// For machines: 17 digits, NULL empty.
  std::string to_string() const;

  using Held = std::variant<std::monostate, std::int64_t, double, std::string>;
  const Held& held() const { return held_; }

 private:
  template <class T>
  const T& as() const {
    if (const T* value = std::get_if<T>(&held_)) return *value;
    throw WrongKind();
  }

  Held held_;
};

using Values = std::vector<Value>;
using Columns = std::vector<std::pair<std::string, Value>>;

/// One row of an answer.
class Row {
 public:
  Row(const std::vector<std::string>& names, Values values) : names_(&names), values_(std::move(values)) {}

  const Value& operator[](std::string_view name) const;
  const std::vector<std::string>& names() const { return *names_; }
  const Values& values() const { return values_; }

 private:
  const std::vector<std::string>* names_;
  Values values_;
};

/// Asked again and again while another process locks the file, with the seconds that this has lasted: whether to wait
/// on. An exception ends the wait.
using Patience = std::function<bool(double seconds)>;

/// One connection to an SQLite file, foreign keys on. Every error of SQLite is a UsageError with the file's name.
class Database {
 public:
  enum class Access { create, write, read, in_memory };  ///< in_memory: a new one; the file is named in messages only

  Database(std::filesystem::path file, Access access);

  const std::filesystem::path& file() const { return file_; }
  bool writable() const;
  bool in_transaction() const;

  /// Changes how long to wait for another process that locks the file: ten seconds without a patience.
  void wait_with(Patience patience);

  /// Executes statements without parameters or answers, separated by semicolons.
  void execute(const std::string& statements);

  /// Executes one statement; returns the number of rows that it changed.
  std::int64_t change(const std::string& statement, const Values& values);

  /// Inserts one row, with `conflict` ("ON CONFLICT ...") at the end of the statement; the number of rows changed.
  std::int64_t insert(const std::string& table, const Columns& columns, const std::string& conflict = {});

  std::int64_t last_row_id() const;
  std::int64_t bytes() const;  ///< of the file

  /// Calls visit(row) for each row of an answer. A row is valid only during that call.
  void each(const std::string& query, const Values& values, const std::function<void(const Row&)>& visit) const;

  /// Names of the columns of an answer, which may have no rows.
  std::vector<std::string> columns(const std::string& query) const;

  /// First column of the first row; NULL when there is none.
  Value scalar(const std::string& query, const Values& values = {}) const;

  /// Throws the UsageError of a store in which something is not as it was written.
  [[noreturn]] void fail_damaged(const std::string& what) const;

 private:
  struct Closer {
    void operator()(sqlite3* connection) const;
  };

  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Finalizer>;

  Statement prepared(const std::string& text) const;
  void require(int code) const;
  [[noreturn]] void fail(int code) const;

  struct Wait {
    Patience patience;
    std::chrono::steady_clock::time_point since;
  };
  /// Waits a moment for another process that locks the file, or returns 0 where the patience is at an end. `waits` is
  /// how often it was called before for the same lock.
  static int wait_on(void* wait, int waits);

  std::filesystem::path file_;
  std::unique_ptr<Wait> wait_ = std::make_unique<Wait>();  ///< the connection knows its place
  std::unique_ptr<sqlite3, Closer> connection_;
  /// Prepared statements by their texts, kept because preparing takes longer than running most statements. A statement
  /// that is running is not among them.
  mutable std::map<std::string, Statement> idle_;
};

/// All or nothing: what is not committed is rolled back. `write` takes the write lock at once (BEGIN IMMEDIATE), so a
/// transaction never fails half-way because another process writes; `read` sees one state of the store.
class Transaction {
 public:
  enum class Kind { read, write };

  Transaction(Database& database, Kind kind);
  ~Transaction() { roll_back(); }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();
  void roll_back() noexcept;

 private:
  Database& database_;
};

}  // namespace mpmvv::store
