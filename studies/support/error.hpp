#pragma once
#include <stdexcept>
#include <string>

namespace mpmvv::support {

/// Bad input: one line that says what is wrong, where, and what would be right. The program exits with 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or folder cannot be written, as on a full disk. A type of its own, because the case that was run is not at
/// fault (records::failure_of).
struct WriteError : UsageError {
  using UsageError::UsageError;
};

}  // namespace mpmvv::support
