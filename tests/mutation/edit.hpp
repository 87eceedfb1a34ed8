#pragma once
#include <cstddef>
#include <string>

namespace mpmvv::mutation {

/// Bytes of a text, from the first to before the last.
struct Region {
  std::size_t begin = 0, end = 0;

  bool holds(const Region& other) const { return begin <= other.begin && other.end <= end; }
};

/// A change of one place in a file of the tree.
struct Edit {
  std::string file;           ///< from the top of the tree
  std::size_t at = 0;         ///< first byte
  std::string before, after;  ///< what stands there, and what is to stand there

  bool operator==(const Edit&) const = default;
};

/// The text with the edit; it must hold `before` at that place.
std::string edited(const Edit& edit, const std::string& text);

/// The line of a byte, counted from 1.
int line_of(const std::string& text, std::size_t at);

/// The whole lines that hold `length` bytes from `at`, without the first one's indentation.
std::string lines_at(const std::string& text, std::size_t at, std::size_t length);

}  // namespace mpmvv::mutation
