#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "studies/codes/particle_table.hpp"
#include "studies/codes/readers.hpp"

namespace mpmvv::codes {

std::string capital(std::string_view word);  ///< the word in capital letters

/// A legacy VTK file, read from its beginning to its end: lines of words, and behind some of them numbers, as text or
/// in binary with the most significant byte first. All functions throw UsageError, which says the place, where the file
/// breaks the format or ends early, and take no more memory than the size of the file justifies.
class LegacyVtkText {
 public:
  explicit LegacyVtkText(const Source& source);  ///< reads the first lines, up to ASCII or BINARY

  std::string_view title() const { return title_; }
  std::string place() const;  ///< "FILE:LINE", or in a binary file "FILE at byte N", for messages
  [[noreturn]] void fail(std::string_view what, const std::string& right) const;

  std::vector<std::string_view> words();  ///< those of the next line that is not blank; none at the end of the file
  std::size_t count(const std::vector<std::string_view>& words, std::size_t k) const;  ///< word k, a whole number
  std::string_view word(const std::vector<std::string_view>& words, std::size_t k) const;
  bool is_before(std::string_view keyword) const;  ///< whether the keyword begins the next line that is not blank
  void skip_to_blank_line();

  /// Reads the numbers of an array of a type, as legacy files call it: unsigned_char, ..., double, vtkIdType. Returns a
  /// column for each component: NAME, or NAME:0, NAME:1, ... if there are several.
  std::vector<TableColumn> numbers(const std::string& name, std::size_t components, std::size_t tuples,
                                   std::string_view type);
  /// Skips so many numbers. In text it skips all numbers that follow, as a count that is not needed may be wrong.
  void skip_numbers(std::size_t how_many, std::string_view type);
  void skip_strings(std::size_t how_many);

 private:
  std::string_view left() const { return content_.substr(at_); }
  std::string_view line();
  void skip_blanks();
  std::string_view next_text() const;
  std::string_view bytes(std::size_t how_many, const std::string& what);
  std::vector<TableColumn> texts(const std::string& name, std::vector<TableColumn> columns, std::size_t tuples);

  std::string_view content_;
  std::string file_, title_;
  std::size_t at_ = 0;
  bool is_binary_ = false;
};

}  // namespace mpmvv::codes
