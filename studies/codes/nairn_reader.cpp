#include <fmt/format.h>

#include <algorithm>

#include "studies/codes/readers.hpp"
#include "studies/codes/record_columns.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

constexpr std::size_t header_size = 64;

/// The header of an archive. In the file it is: "ver6"; a length and so many letters that say what particles have, of
/// which the first is 'i' if numbers have their least significant byte first; the same for cracks; the dimension; the
/// kind of grid; the time.
struct ArchiveHeader {
  std::string particles, cracks;
  std::size_t dimension;
  bool is_big_endian;
  double time;
};

[[noreturn]] void fail(const Source& source) {
  throw UsageError(fmt::format("no header of a particle archive in {} (ver6 of nairn-mpm-fea)", source.file));
}

ArchiveHeader read_header(const Source& source) {
  const std::string& content = source.content;
  if (content.size() < header_size || !content.starts_with("ver6")) fail(source);
  ArchiveHeader header;
  std::size_t at = 4;
  for (std::string* letters : {&header.particles, &header.cracks}) {
    const std::size_t length = static_cast<unsigned char>(content[at]);
    if (length < 2 || at + 1 + length + 8 > header_size) fail(source);
    *letters = content.substr(at + 1, length);
    at += 1 + length;
  }
  header.dimension = content[at] == '3' ? 3 : 2;
  header.is_big_endian = header.particles[0] != 'i';
  header.time = number_at(&content[at + 2], {'f', 4}, header.is_big_endian);
  return header;
}

/// Returns how many of a material's history numbers are in the file. The letter is Y for the first one, N for none,
/// else it has a bit for each.
std::size_t history_numbers(char letter) {
  if (letter == 'Y' || letter == 'N') return letter == 'Y' ? 1 : 0;
  std::size_t count = 0;
  for (int bit = 0; bit < 5; ++bit) count += static_cast<std::size_t>(letter >> bit & 1);
  return count;
}

/// Returns how many bytes of a record belong to the letter at this place of the header.
std::size_t size_of_item(std::size_t place, char letter, std::size_t dimension) {
  const std::size_t vector = 8 * dimension, tensor = dimension == 3 ? 48 : 32, rotation = dimension == 3 ? 24 : 8;
  const std::vector<std::size_t> sizes{0,      0,        vector,   tensor, tensor, tensor,     0,     8, 8,
                                       8,      0,        16,       8,      0,      8 + vector, 8,     4, rotation,
                                       vector, rotation, rotation, 0,      0,      0,          vector};
  constexpr std::size_t histories[] = {13, 21, 22, 23};
  if (std::find(std::begin(histories), std::end(histories), place) != std::end(histories))
    return 8 * history_numbers(letter);
  return letter == 'Y' && place < sizes.size() ? sizes[place] : 0;
}

/// The fields with which a particle's record begins, and the size of all records: that of a particle or of a crack,
/// whichever is larger.
struct ArchiveRecord {
  std::vector<RecordField> fields;
  std::size_t size = 0;

  explicit ArchiveRecord(const ArchiveHeader& header) {
    const std::size_t dimension = header.dimension;
    add("element", {'i', 4});
    add("m", {'f', 8});
    size += 4;  // material
    for (const char* name : {"angle", "thickness", "angle_x"})
      if (dimension == 3 || std::string(name) != "angle_x") add(name, {'f', 8});
    add_vector({"x", "y", "z"}, dimension);
    add_vector({"X", "Y", "Z"}, dimension);
    if (header.particles.size() > 2 && header.particles[2] == 'Y') add_vector({"v_x", "v_y", "v_z"}, dimension);
    if (header.particles.size() > 3 && header.particles[3] == 'Y')
      add_vector({"s_xx", "s_yy", "s_zz", "s_xy", "s_xz", "s_yz"}, dimension == 3 ? 6 : 4);
    for (std::size_t place = 4; place < header.particles.size(); ++place)
      size += size_of_item(place, header.particles[place], dimension);
    size = std::max(size, size_of_crack(header));
  }

 private:
  void add(const std::string& name, NumberType type) {
    fields.push_back({name, type, size});
    size += type.size;
  }

  void add_vector(const std::vector<std::string>& names, std::size_t components) {
    for (std::size_t k = 0; k < components; ++k) add(names[k], {'f', 8});
  }

  static std::size_t size_of_crack(const ArchiveHeader& header) {
    std::size_t bytes = 24 + 32 * header.dimension;
    for (std::size_t place = 2; place < header.cracks.size(); ++place) {
      const bool is_there = header.cracks[place] == 'Y';
      if (place < 5) bytes += is_there ? (place == 4 ? 20 : 16) : 0;
      if (place >= 5) bytes += 8 * history_numbers(header.cracks[place]);
    }
    return bytes;
  }
};

}  // namespace

/// Reads a binary particle archive of nairn-mpm-fea. The names of these files end in the number of a step. The archive
/// has doubles and the original position of every particle; the code's text extracts have only six digits.
ParticleTable read_nairn(const Source& source) {
  const ArchiveHeader header = read_header(source);
  const ArchiveRecord record(header);
  const std::string_view records = std::string_view(source.content).substr(header_size);
  if (records.empty() || records.size() % record.size != 0)
    throw UsageError(fmt::format("{} bytes behind the header of {} (whole records of {} bytes)", records.size(),
                                 source.file, record.size));
  ParticleTable table;
  table.columns = columns_of(records, record.size, record.fields, header.is_big_endian);
  table.time = header.time;
  return table;
}

/// Reads an archive of a run without `ConsistentUnits`. Its units are mm, g and s, but the header's time is in ms: it
/// is converted to s.
ParticleTable read_nairn_legacy(const Source& source) {
  ParticleTable table = read_nairn(source);
  *table.time *= 1e-3;
  return table;
}

}  // namespace mpmvv::codes
