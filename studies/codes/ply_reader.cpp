#include <fmt/format.h>

#include <charconv>

#include "studies/codes/readers.hpp"
#include "studies/codes/record_columns.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

struct PlyHeader {
  std::string format;
  std::size_t vertices = 0;
  bool in_vertices = false, has_vertices = false;
  std::vector<RecordField> fields;
  std::size_t record_size = 0;
};

[[noreturn]] void fail(const TextLines& lines, std::string_view line, const std::string& right) {
  throw UsageError(fmt::format("'{}' in {} ({})", line.substr(0, 80), lines.place(), right));
}

void read_element(PlyHeader& header, const std::vector<std::string_view>& words, const TextLines& lines,
                  std::string_view line) {
  header.in_vertices = words.size() == 3 && words[1] == "vertex";
  if (!header.in_vertices) {
    if (!header.has_vertices) fail(lines, line, "vertices before all other elements");
    return;
  }
  const char* end = words[2].data() + words[2].size();
  const auto [stop, error] = std::from_chars(words[2].data(), end, header.vertices);
  if (error != std::errc() || stop != end) fail(lines, line, "element vertex, and how many");
  header.has_vertices = true;
}

void read_property(PlyHeader& header, const std::vector<std::string_view>& words, const TextLines& lines,
                   std::string_view line) {
  if (!header.in_vertices) return;
  const auto type = words.size() == 3 ? number_type(words[1]) : std::nullopt;
  if (!type) fail(lines, line, "a number, as in property double x");
  header.fields.push_back({std::string(words[2]), *type, header.record_size});
  header.record_size += type->size;
}

/// Reads the lines up to end_header. What comments say goes into the table.
PlyHeader read_header(TextLines& lines, ParticleTable& table) {
  PlyHeader header;
  if (const auto magic = lines.next(); magic != "ply") fail(lines, magic.value_or(""), "ply in the first line");
  while (const auto line = lines.next()) {
    const auto words = fields_of(*line, ' ');
    if (words[0] == "end_header") return header;
    if (words[0] == "format" && words.size() > 1) header.format = words[1];
    if (words[0] == "element") read_element(header, words, lines, *line);
    if (words[0] == "property") read_property(header, words, lines, *line);
    if (words[0] == "comment") note_comment(table, line->substr(words[0].size()), lines);
  }
  throw UsageError(fmt::format("no end_header in {} (a PLY file)", lines.place()));
}

void read_lines(TextLines& lines, const PlyHeader& header, ParticleTable& table) {
  for (const RecordField& field : header.fields) table.columns.push_back({.name = field.name});
  for (std::size_t p = 0; p < header.vertices; ++p) {
    const auto line = lines.next();
    if (!line) throw UsageError(fmt::format("{} of {} vertices in {} (all)", p, header.vertices, lines.place()));
    add_row(table, fields_of(*line, ' '), lines);
  }
}

}  // namespace

/// Reads the vertices of a PLY file, as text or as binary numbers in either byte order.
ParticleTable read_ply(const Source& source) {
  ParticleTable table;
  TextLines lines(source);
  const PlyHeader header = read_header(lines, table);
  if (header.vertices == 0 || header.fields.empty())
    throw UsageError(fmt::format("no vertices in {} (element vertex, with properties)", source.file));
  if (header.format == "ascii") {
    read_lines(lines, header, table);
    return table;
  }
  if (header.format != "binary_little_endian" && header.format != "binary_big_endian")
    throw UsageError(fmt::format("format '{}' in {} (known: ascii, binary_little_endian, binary_big_endian)",
                                 header.format, source.file));
  if (lines.left().size() / header.record_size < header.vertices)
    throw UsageError(fmt::format("{} bytes behind the header of {} ({} vertices of {} bytes)", lines.left().size(),
                                 source.file, header.vertices, header.record_size));
  table.columns = columns_of(lines.left().substr(0, header.vertices * header.record_size), header.record_size,
                             header.fields, header.format == "binary_big_endian");
  return table;
}

}  // namespace mpmvv::codes
