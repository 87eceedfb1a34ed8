#include <fmt/format.h>

#include <algorithm>

#include "studies/codes/readers.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

bool are_numbers(const std::vector<std::string_view>& fields) {
  for (const std::string_view field : fields)
    if (TableColumn ignored; !add_text(ignored, field)) return false;
  return true;
}

/// Returns the character that separates the fields of the line: a comma, semicolon or tab if it has one, else a blank.
char separator_of(std::string_view line) {
  for (const char c : {',', ';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

/// Returns the words of a comment if it may name the columns; none if it has a number or says `key = value`.
std::vector<std::string_view> names_in(std::string_view comment) {
  if (comment.empty()) return {};
  const auto is_number = [](std::string_view field) { return are_numbers({field}); };
  auto names = fields_of(comment, separator_of(comment));
  if (comment.find('=') != std::string_view::npos || std::ranges::any_of(names, is_number)) names.clear();
  return names;
}

/// Requires that commas separate fields and are no decimal ones: of 1;0,25;0,5 they would make 1;0 and 25;0 and 5.
void require_no_decimal_commas(const std::vector<std::string_view>& fields, const TextLines& lines) {
  for (const std::string_view field : fields)
    if (field.find_first_of("; \t") != std::string_view::npos && are_numbers(fields_of(field, separator_of(field))))
      throw UsageError(
          fmt::format("'{}' between commas in {} (decimal commas? Write points)", field.substr(0, 40), lines.place()));
}

}  // namespace

/// Reads lines of numbers, separated by commas, semicolons, tabs or blanks. The first line names the columns unless it
/// has only numbers. In that case the last comment above it that has no number and no = names them if it has as many
/// words; else their names are 1, 2, ... Comments begin with # or %.
ParticleTable read_csv(const Source& source) {
  ParticleTable table;
  std::vector<std::string_view> comment_names;
  TextLines lines(source);
  while (auto line = lines.next()) {
    const std::string_view text = trimmed(*line);
    if (text.empty()) continue;
    if (text.front() == '#' || text.front() == '%') {
      const std::string_view comment = trimmed(text.substr(1));
      if (const auto names = names_in(comment); table.columns.empty() && !names.empty()) comment_names = names;
      note_comment(table, comment, lines);
      continue;
    }
    const auto fields = fields_of(text, separator_of(text));
    if (table.columns.empty()) {
      const bool has_header = !are_numbers(fields);
      const bool is_named = has_header || comment_names.size() == fields.size();
      const auto& names = has_header ? fields : comment_names;
      for (std::size_t k = 0; k < fields.size(); ++k)
        table.columns.push_back({.name = is_named ? std::string(names[k]) : std::to_string(k + 1)});
      if (has_header) continue;
    }
    require_no_decimal_commas(fields, lines);
    add_row(table, fields, lines);
  }
  if (table.columns.empty() || table.columns.front().values.empty())
    throw NoParticles(fmt::format("no lines of numbers in {} (a header, then a line for each particle)", source.file));
  return table;
}

}  // namespace mpmvv::codes
