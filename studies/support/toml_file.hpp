#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mpmvv::support {

/// A table of a TOML file, read only. Every access checks the type; every message is a UsageError of the form
/// "what is wrong in FILE:LINE (what would be right)".
class TomlTable {
 public:
  /// Absent file, unreadable file and syntax errors (with line) are UsageErrors.
  static TomlTable read(const std::filesystem::path& file);
  /// The same from text; `name` stands for the file in messages.
  static TomlTable parse(const std::string& text, const std::string& name);

  bool has(const std::string& key) const;
  std::vector<std::string> keys() const;            ///< in the order of the file
  std::string where() const;                        ///< "FILE:LINE" of this table
  std::string where(const std::string& key) const;  ///< "FILE:LINE" of the value, of the table when absent

  /// UsageError that names the unknown key, its line, and the known ones.
  void allow_only(const std::vector<std::string>& known) const;

  std::string text(const std::string& key) const;  ///< required
  std::string text(const std::string& key, const std::string& absent) const;
  double number(const std::string& key) const;  ///< integer or float, finite; required
  double number(const std::string& key, double absent) const;
  bool flag(const std::string& key, bool absent) const;
  std::vector<double> numbers(const std::string& key) const;     ///< required, may be empty
  std::vector<std::string> texts(const std::string& key) const;  ///< absent: empty
  std::optional<TomlTable> table(const std::string& key) const;  ///< absent: nullopt
  std::vector<TomlTable> tables(const std::string& key) const;   ///< array of tables; absent: empty

  /// A scalar as the user would write it on a command line (0.2, cd, true): for settings shared with `run`.
  std::string scalar_text(const std::string& key) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

}  // namespace mpmvv::support
