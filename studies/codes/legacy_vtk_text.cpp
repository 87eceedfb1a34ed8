#include "studies/codes/legacy_vtk_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "studies/codes/record_columns.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

constexpr std::string_view white = " \t\r\n";

/// Returns the type that legacy files call so; nullopt if there is none. vtkIdType has four bytes there.
std::optional<NumberType> legacy_type(std::string_view word) {
  std::string name = capital(word);
  if (name == "VTKIDTYPE") return number_type("int32");
  if (name.starts_with("VTKTYPE")) name.erase(0, 7);
  if (name.starts_with("UNSIGNED_")) name.replace(0, 9, "U");
  if (name.starts_with("SIGNED_")) name.erase(0, 7);
  if (name == "LONG" || name == "LONG_LONG") name = "INT64";
  if (name == "ULONG" || name == "ULONG_LONG") name = "UINT64";
  return number_type(name);
}

}  // namespace

std::string capital(std::string_view word) {
  std::string all(word);
  std::ranges::transform(all, all.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return all;
}

LegacyVtkText::LegacyVtkText(const Source& source) : content_(source.content), file_(source.file) {
  if (content_.substr(std::min(content_.find_first_not_of(white), content_.size())).starts_with('<'))
    throw UsageError(fmt::format("XML in {} (a legacy VTK file; format vtu is VTK's XML)", file_));
  const std::string_view first = line();
  if (!first.starts_with("# vtk DataFile Version"))
    throw UsageError(
        fmt::format("'{}' in {} (a legacy VTK file, whose first line is # vtk DataFile Version and a number)",
                    first.substr(0, 40), file_));
  title_ = line();
  const auto third = words();
  const std::string kind = third.empty() ? "" : capital(third[0]);
  if (kind != "ASCII" && kind != "BINARY") fail(third.empty() ? "" : third[0], "ASCII or BINARY below the title");
  is_binary_ = kind == "BINARY";
}

std::string LegacyVtkText::place() const {
  if (is_binary_) return fmt::format("{} at byte {}", file_, at_);
  return fmt::format("{}:{}", file_, std::ranges::count(content_.substr(0, at_ > 0 ? at_ - 1 : 0), '\n') + 1);
}

void LegacyVtkText::fail(std::string_view what, const std::string& right) const {
  const std::string found = what.empty() ? "the file ends" : fmt::format("'{}'", what.substr(0, 40));
  throw UsageError(fmt::format("{} in {} ({})", found, place(), right));
}

std::vector<std::string_view> LegacyVtkText::words() {
  skip_blanks();
  return left().empty() ? std::vector<std::string_view>() : fields_of(line(), ' ');
}

std::size_t LegacyVtkText::count(const std::vector<std::string_view>& words, std::size_t k) const {
  const std::string_view text = word(words, k);
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (stop != text.data() + text.size() || error != std::errc()) fail(text, "how many there are");
  return value;
}

std::string_view LegacyVtkText::word(const std::vector<std::string_view>& words, std::size_t k) const {
  if (k >= words.size()) fail(fmt::format("{}", words[0]), fmt::format("at least {} words behind it", k));
  return words[k];
}

bool LegacyVtkText::is_before(std::string_view keyword) const {
  const auto at = std::min(content_.find_first_not_of(white, at_), content_.size());
  return capital(content_.substr(at, keyword.size())) == keyword;
}

void LegacyVtkText::skip_to_blank_line() {
  while (!left().empty() && !trimmed(line()).empty()) continue;
}

std::vector<TableColumn> LegacyVtkText::numbers(const std::string& name, std::size_t components, std::size_t tuples,
                                                std::string_view type) {
  const auto number = legacy_type(type);
  if (!number) fail(type, fmt::format("the type of '{}': int, float, double, ...", name));
  if (components == 0 || components > 100)
    fail(std::to_string(components), fmt::format("components of '{}', from 1 to 100", name));
  std::vector<RecordField> fields;
  for (std::size_t k = 0; k < components; ++k)
    fields.push_back({components == 1 ? name : fmt::format("{}:{}", name, k), *number, k * number->size});
  if (!is_binary_) {
    std::vector<TableColumn> columns;
    for (const RecordField& field : fields) columns.push_back({.name = field.name});
    return texts(name, std::move(columns), tuples);
  }
  const std::size_t size = components * number->size;
  if (tuples > left().size() / size) fail(std::to_string(tuples), fmt::format("not more of '{}' than there are", name));
  return columns_of(bytes(tuples * size, name), size, fields, true);
}

std::vector<TableColumn> LegacyVtkText::texts(const std::string& name, std::vector<TableColumn> columns,
                                              std::size_t tuples) {
  for (std::size_t tuple = 0; tuple < tuples; ++tuple)
    for (TableColumn& column : columns) {
      skip_blanks();
      const std::string_view text = next_text();
      at_ += text.size();
      if (!add_text(column, text)) fail(text, fmt::format("{} numbers of '{}'", tuples * columns.size(), name));
    }
  return columns;
}

void LegacyVtkText::skip_numbers(std::size_t how_many, std::string_view type) {
  const auto number = legacy_type(type);
  if (!number) fail(type, "the type of numbers: int, vtktypeint64, ...");
  if (is_binary_) {
    if (how_many > left().size() / number->size) fail(std::to_string(how_many), "not more than there are");
    at_ += how_many * number->size;
    return;
  }
  for (TableColumn ignored;; ignored.values.clear()) {
    skip_blanks();
    const std::string_view text = next_text();
    if (!add_text(ignored, text)) return;
    at_ += text.size();
  }
}

/// In binary each string has its length before it: the first two bits say in how many bytes it is.
void LegacyVtkText::skip_strings(std::size_t how_many) {
  for (std::size_t k = 0; k < how_many; ++k) {
    if (left().empty()) fail("", fmt::format("{} strings", how_many));
    if (!is_binary_) {
      line();
      continue;
    }
    const auto first = static_cast<unsigned char>(left().front());
    const std::size_t size = std::size_t{1} << (3 - (first >> 6));
    std::string length(bytes(size, "a string"));
    if (size < 8) length[0] = static_cast<char>(first & 0x3f);
    bytes(static_cast<std::size_t>(number_at(length.data(), {'u', size}, true)), "a string");
  }
}

std::string_view LegacyVtkText::line() {
  const auto end = std::min(left().find('\n'), left().size());
  const std::string_view text = left().substr(0, end);
  at_ = std::min(at_ + end + 1, content_.size());
  return trimmed(text);
}

void LegacyVtkText::skip_blanks() {
  at_ = std::min(content_.find_first_not_of(white, at_), content_.size());
}

/// Returns the text up to the next blank.
std::string_view LegacyVtkText::next_text() const {
  return left().substr(0, left().find_first_of(white));
}

std::string_view LegacyVtkText::bytes(std::size_t how_many, const std::string& what) {
  if (how_many > left().size()) fail(what, "a whole file");
  const std::string_view all = left().substr(0, how_many);
  at_ += how_many;
  return all;
}

}  // namespace mpmvv::codes
