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
  explicit TextLines(const Source& source);  ///< a byte-order mark before the first is skipped

  std::optional<std::string_view> next();  ///< without its end; none behind the last one
  std::string_view left() const { return left_; }

  std::size_t number() const { return number_; }  ///< of the last one, from 1
  std::string place() const;                      ///< "FILE:LINE" of it

 private:
  std::string_view left_;
  std::string file_;
  std::size_t number_ = 0;
};

std::string_view trimmed(std::string_view text);  ///< without blanks around it

/// What stands between separators, without blanks and quotes around it; between blanks when that is the separator.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// A number for each column; UsageError with the line's place otherwise.
void add_row(ParticleTable& table, const std::vector<std::string_view>& fields, const TextLines& lines);

/// Takes in what a comment says: `key = value` or `key: value`, among others the time.
void note_comment(ParticleTable& table, std::string_view comment);

}  // namespace mpmvv::codes
