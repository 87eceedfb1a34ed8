#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/codes/readers.hpp"

namespace mpmvv::codes {

/// The lines of a source, one after the other.
class TextLines {
 public:
  explicit TextLines(const Source& source);  ///< skips a byte-order mark before the first line

  std::optional<std::string_view> next();  ///< the next line without its end; nullopt after the last
  std::string_view left() const { return left_; }

  std::size_t number() const { return number_; }  ///< number of the line that was read last, from 1
  std::string place() const;                      ///< "FILE:LINE" of that line

 private:
  std::string_view left_;
  std::string file_;
  std::size_t number_ = 0;
};

std::string_view trimmed(std::string_view text);  ///< the text without blanks around it

/// Splits the line at the separator and returns the parts, without blanks and quotes around them. A blank as separator
/// stands for any number of blanks and tabs.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// Adds a row to the table. Throws UsageError with the line's place unless the fields are a number for each column.
void add_row(ParticleTable& table, const std::vector<std::string_view>& fields, const TextLines& lines);

/// Notes in the table what a comment says, `key = value` or `key: value`, also several with commas or semicolons
/// between, and the time and step that it states (`note_time`). Throws UsageError, which says the line's place, for a
/// time in another unit than s.
void note_comment(ParticleTable& table, std::string_view comment, const TextLines& lines);

}  // namespace mpmvv::codes
