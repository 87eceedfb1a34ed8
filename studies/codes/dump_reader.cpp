#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <ranges>

#include "studies/codes/readers.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

constexpr std::string_view item = "ITEM: ";

/// Reads a line that is a whole number. Throws UsageError if it is anything else.
std::int64_t whole_line(TextLines& lines, const char* what) {
  const std::string_view text = trimmed(lines.next().value_or(""));
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size())
    throw UsageError(fmt::format("'{}' in {} ({})", text.substr(0, 40), lines.place(), what));
  return value;
}

/// The lines from one ITEM: TIMESTEP to the next: the state after one time step.
class Frame {
 public:
  std::int64_t step = 0;
  std::optional<double> time;
  std::int64_t atoms = -1;
  std::vector<std::string_view> names;
  std::optional<TextLines> rows;  ///< the lines from the first atom on, parsed only for the step asked for

  /// Reads the lines of an item. For an item that is not known it reads none: the caller skips them one by one.
  void read(std::string_view title, TextLines& lines) {
    if (title == "TIMESTEP") step = whole_line(lines, "the number of a step");
    if (title == "NUMBER OF ATOMS") atoms = whole_line(lines, "how many there are");
    if (title == "TIME") {
      TableColumn number;
      if (add_text(number, trimmed(lines.next().value_or("")))) time = number.values.front();
    }
    if (title.starts_with("ATOMS")) read_atoms(title.substr(5), lines);
  }

 private:
  void read_atoms(std::string_view title, TextLines& lines) {
    names = fields_of(title, ' ');
    rows = lines;
    for (std::int64_t p = 0; p < atoms; ++p) {
      const auto row = lines.next();
      if (!row || row->starts_with(item))
        throw UsageError(fmt::format("{} of {} atoms of step {} in {} (all)", p, atoms, step, lines.place()));
    }
  }
};

std::vector<Frame> read_frames(TextLines& lines) {
  std::vector<Frame> frames;
  while (const auto line = lines.next()) {
    if (!line->starts_with(item)) continue;
    const std::string_view title = trimmed(line->substr(item.size()));
    if (title == "TIMESTEP") frames.emplace_back();
    if (frames.empty()) throw UsageError(fmt::format("'{}' in {} (ITEM: TIMESTEP first)", *line, lines.place()));
    frames.back().read(title, lines);
  }
  return frames;
}

/// Returns the frame of the step asked for, the last one if there are several, or without a step the last of all.
/// Throws UsageError if there is none.
const Frame& frame_of(const std::vector<Frame>& frames, const Source& source) {
  for (const Frame& frame : std::views::reverse(frames))
    if (!source.step || frame.step == *source.step) return frame;
  std::vector<std::int64_t> steps;
  for (const Frame& frame : frames) steps.push_back(frame.step);
  throw UsageError(fmt::format("no step {} in {} (known: {})", *source.step, source.file, fmt::join(steps, ", ")));
}

}  // namespace

/// Reads atoms as LAMMPS dumps them: ITEM: TIMESTEP, ITEM: NUMBER OF ATOMS, ITEM: ATOMS id x y ..., once or several
/// times in a file.
ParticleTable read_dump(const Source& source) {
  TextLines lines(source);
  const std::vector<Frame> frames = read_frames(lines);
  if (frames.empty()) throw UsageError(fmt::format("no ITEM: TIMESTEP in {} (a dump of atoms)", source.file));
  const Frame& frame = frame_of(frames, source);
  if (!frame.rows || frame.atoms < 1)
    throw UsageError(fmt::format("no atoms of step {} in {} (ITEM: ATOMS id x y ...)", frame.step, source.file));
  ParticleTable table;
  table.time = frame.time;
  table.step = frame.step;
  for (const std::string_view name : frame.names) table.columns.push_back({.name = std::string(name)});
  TextLines rows = *frame.rows;
  for (std::int64_t p = 0; p < frame.atoms; ++p) add_row(table, fields_of(*rows.next(), ' '), rows);
  return table;
}

}  // namespace mpmvv::codes
