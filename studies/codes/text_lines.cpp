#include "studies/codes/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/codes/stated_time.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

TextLines::TextLines(const Source& source) : left_(source.content), file_(source.file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (left_.starts_with(byte_order_mark)) left_.remove_prefix(byte_order_mark.size());
}

std::optional<std::string_view> TextLines::next() {
  if (left_.empty()) return std::nullopt;
  const auto end = left_.find('\n');
  const std::string_view line = left_.substr(0, end);
  left_.remove_prefix(end == std::string_view::npos ? left_.size() : end + 1);
  ++number_;
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::string TextLines::place() const {
  return fmt::format("{}:{}", file_, number_);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  const std::string_view ends = separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
  std::vector<std::string_view> fields;
  line = trimmed(line);
  for (bool more = true; more;) {
    const auto end = line.find_first_of(ends);
    more = end != std::string_view::npos;
    std::string_view field = trimmed(line.substr(0, end));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    if (more) line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line);
  }
  return fields;
}

void add_row(ParticleTable& table, const std::vector<std::string_view>& fields, const TextLines& lines) {
  if (fields.size() != table.columns.size())
    throw UsageError(fmt::format("{} numbers in {} (as many as there are columns: {})", fields.size(), lines.place(),
                                 table.columns.size()));
  table.lines.push_back(lines.number());
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (!add_text(table.columns[k], fields[k]))
      throw UsageError(
          fmt::format("'{}' for '{}' in {} (a number)", fields[k].substr(0, 40), table.columns[k].name, lines.place()));
}

namespace {

constexpr std::string_view signs = "=:";

/// Returns the parts of `cells = 8, ppc = 2` if each is a statement, with one sign; else the whole comment, as
/// `boundary = xmin=wall,xmax=free` is.
std::vector<std::string_view> statements_in(std::string_view comment) {
  const auto parts = fields_of(comment, comment.find(';') == std::string_view::npos ? ',' : ';');
  const auto has_one_sign = [](std::string_view part) {
    const auto first = part.find_first_of(signs);
    return first != std::string_view::npos && part.find_first_of(signs, first + 1) == std::string_view::npos;
  };
  return std::ranges::all_of(parts, has_one_sign) ? parts : std::vector{comment};
}

}  // namespace

void note_comment(ParticleTable& table, std::string_view comment, const TextLines& lines) {
  note_time(table, comment, lines.place());
  for (const std::string_view statement : statements_in(comment)) {
    const auto middle = statement.find_first_of(signs);
    if (middle == std::string_view::npos) return;
    const std::string key(trimmed(statement.substr(0, middle))), value(trimmed(statement.substr(middle + 1)));
    if (!key.empty() && key.find_first_of(" \t") == std::string::npos) table.says[key] = value;
  }
}

}  // namespace mpmvv::codes
