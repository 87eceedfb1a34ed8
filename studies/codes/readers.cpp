#include "studies/codes/readers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

std::vector<std::string> format_words() {
  std::vector<std::string> words;
  for (const Format& format : formats()) words.push_back(format.word);
  return words;
}

const Format& format_of(const std::filesystem::path& file, const std::string& word) {
  for (const Format& format : formats()) {
    const auto ends = [&](const std::string& ending) { return file.string().ends_with(ending); };
    if (word.empty() ? std::any_of(format.endings.begin(), format.endings.end(), ends) : format.word == word)
      return format;
  }
  if (!word.empty())
    throw UsageError(fmt::format("unknown format '{}' in --format (known: {})", word, fmt::join(format_words(), ", ")));
  throw UsageError(fmt::format("the name of {} does not say its format (--format {})", file.string(),
                               fmt::join(format_words(), "|")));
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {"csv", {".csv", ".txt", ".dat", ".tsv"}, &read_csv},
      {"vtu", {".vtu", ".vtp"}, &read_vtu},
      {"ply", {".ply"}, &read_ply},
      {"vtk", {".vtk"}, &read_legacy_vtk},
      {"dump", {".dump", ".lammpstrj", ".custom"}, &read_dump, true},
      {"nairn", {}, &read_nairn},
      {"nairn-legacy", {}, &read_nairn_legacy},
  };
  return all;
}

namespace {

ParticleTable read_table(const std::filesystem::path& file, const Columns& columns, const std::string& format) {
  const Format& known = format_of(file, format);
  if (columns.step && !known.has_steps)
    throw UsageError(fmt::format("--step {} of {}, which holds one state (it is for a dump, which may hold several)",
                                 *columns.step, file.string()));
  const std::string content = support::require_file(file, "what a code wrote of its particles");
  return known.read({content, file.string(), columns.step});
}

/// Reads a part of a state; nullopt if it has no particles.
std::optional<Snapshot> read_part(const std::filesystem::path& file, const Columns& columns,
                                  const std::string& format) try {
  const ParticleTable table = read_table(file, columns, format);
  if (table.columns.empty() || table.columns.front().values.empty()) return std::nullopt;
  Snapshot part = snapshot_of(table, columns, file.string());
  part.parts.push_back({part.file, part.size(), part.says});
  return part;
} catch (const NoParticles&) {
  return std::nullopt;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more, const Snapshot& part, const Snapshot& first) {
  const bool has_all = all.size() == first.size(), has_more = more.size() == part.size();
  if (has_all != has_more)
    throw UsageError(
        fmt::format("{} and {} have other fields (parts of one state with the same ones)", first.file, part.file));
  all.insert(all.end(), more.begin(), more.end());
}

/// Adds the particles of a part to those of the parts before it.
void append(Snapshot& whole, const Snapshot& part) {
  if (part.time != whole.time || part.step != whole.step)
    throw UsageError(fmt::format("{} is of another time than {} (parts of one state)", part.file, whole.file));
  const Snapshot before = whole;
  const auto add = [&](auto member) { append(whole.*member, part.*member, part, before); };
  add(&Snapshot::id), add(&Snapshot::X), add(&Snapshot::x), add(&Snapshot::u), add(&Snapshot::v);
  add(&Snapshot::mass), add(&Snapshot::stress);
  whole.digits = std::min(whole.digits, part.digits);
  whole.rounding = std::max(whole.rounding, part.rounding);
  whole.rounding_of_all = std::max(whole.rounding_of_all, part.rounding_of_all);
  whole.parts.push_back(part.parts.front());
}

}  // namespace

Snapshot read_snapshot(const std::filesystem::path& file, const Columns& columns, const std::string& format) {
  return snapshot_of(read_table(file, columns, format), columns, file.string());
}

Snapshot read_snapshot(const std::vector<std::filesystem::path>& parts, const Columns& columns,
                       const std::string& format) {
  if (parts.size() == 1) return read_snapshot(parts[0], columns, format);
  std::optional<Snapshot> whole;
  for (const std::filesystem::path& file : parts) {
    std::optional<Snapshot> part = read_part(file, columns, format);
    if (whole && part)
      append(*whole, *part);
    else if (part)
      whole = std::move(part);
  }
  if (!whole)
    throw UsageError(fmt::format("no particles in {} and {} more (parts of one state, one at least with particles)",
                                 parts.at(0).string(), parts.size() - 1));
  if (whole->parts.size() > 1) whole->file += fmt::format(" and {} more", whole->parts.size() - 1);
  return *std::move(whole);
}

}  // namespace mpmvv::codes
