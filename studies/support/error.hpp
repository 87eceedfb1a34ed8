#pragma once
#include <stdexcept>
#include <string>

namespace mpmvv::support {

/// The text with `\x00` in place of each NUL, at which an exception's `what()` would end.
inline std::string without_nul(const std::string& text) {
  std::string all;
  for (const char c : text) c == '\0' ? all += "\\x00" : all += c;
  return all;
}

/// Bad input: one line that says what is wrong, where, and what would be right. The program exits with 2.
struct UsageError : std::runtime_error {
  explicit UsageError(const std::string& message) : std::runtime_error(without_nul(message)) {}
};

/// A file or folder cannot be written, as on a full disk. A type of its own, because the case that was run is not at
/// fault (records::failure_of).
struct WriteError : UsageError {
  using UsageError::UsageError;
};

}  // namespace mpmvv::support
