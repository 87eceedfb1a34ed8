#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <map>

#include "studies/codes/legacy_vtk_text.hpp"
#include "studies/codes/readers.hpp"
#include "studies/codes/stated_time.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

/// Returns a name in which VTK has written characters such as blanks as % and two digits to base 16.
std::string decoded(std::string_view name) {
  const auto is_digit = [&](std::size_t at) { return std::isxdigit(static_cast<unsigned char>(name[at])) != 0; };
  std::string all;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const bool is_code = name[k] == '%' && k + 2 < name.size() && is_digit(k + 1) && is_digit(k + 2);
    all += is_code ? static_cast<char>(std::stoi(std::string(name.substr(k + 1, 2)), nullptr, 16)) : name[k];
    if (is_code) k += 2;
  }
  return all;
}

/// Reads the sections of a legacy file one after the other. It keeps the points and their data.
class LegacyVtk {
 public:
  explicit LegacyVtk(const Source& source) : text_(source) {
    note_time_of_title(table_, text_.title(), fmt::format("{}:2", source.file));
    for (Words words = text_.words(); !words.empty(); words = text_.words()) read_section(words);
    if (points_ == 0) throw UsageError(fmt::format("no points in {} (POINTS, and how many)", source.file));
  }

  const ParticleTable& table() const { return table_; }

 private:
  using Words = std::vector<std::string_view>;
  enum class Data { of_file, of_points, of_cells };

  void read_section(const Words& words) {
    const std::string key = capital(words[0]);
    if (key == "DATASET") return require_points(words);
    if (key == "POINTS") return read_points(words);
    if (key == "FIELD") return read_field(words);
    if (key == "METADATA") return text_.skip_to_blank_line();
    if (key == "POINT_DATA" || key == "CELL_DATA") return begin_data(words, key == "POINT_DATA");
    if (!skip_section(key, words)) read_attribute(key, words);
  }

  void require_points(const Words& words) const {
    const std::string kind = capital(text_.word(words, 1));
    if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
      text_.fail(fmt::format("DATASET {}", words[1]), "particles are points of POLYDATA or of an UNSTRUCTURED_GRID");
  }

  void read_points(const Words& words) {
    if (points_ > 0) text_.fail("POINTS", "once");
    points_ = text_.count(words, 1);
    table_.columns = text_.numbers("Points", 3, points_, text_.word(words, 2));
  }

  void begin_data(const Words& words, bool is_of_points) {
    data_ = is_of_points ? Data::of_points : Data::of_cells;
    tuples_ = text_.count(words, 1);
    if (is_of_points && (points_ == 0 || tuples_ != points_))
      text_.fail(fmt::format("POINT_DATA {}", tuples_), fmt::format("of {} points", points_));
  }

  /// Skips cells, or one of the two parts that they have in newer files, or a table of colours. Returns false if it is
  /// another section.
  bool skip_section(const std::string& key, const Words& words) {
    if (key == "OFFSETS" || key == "CONNECTIVITY") {
      text_.skip_numbers(key == "OFFSETS" ? offsets_ : connectivity_, text_.word(words, 1));
    } else if (key == "LOOKUP_TABLE") {
      text_.skip_numbers(4 * text_.count(words, 2), "unsigned_char");
    } else if (key == "CELL_TYPES") {
      text_.skip_numbers(text_.count(words, 1), "int");
    } else if (key == "CELLS" || key == "VERTICES" || key == "LINES" || key == "POLYGONS" || key == "TRIANGLE_STRIPS") {
      offsets_ = text_.count(words, 1);
      connectivity_ = text_.count(words, 2);
      if (!text_.is_before("OFFSETS")) text_.skip_numbers(connectivity_, "int");
    } else {
      return false;
    }
    return true;
  }

  /// Reads an array of point or cell data that has a section of its own.
  void read_attribute(const std::string& key, const Words& words) {
    static const std::map<std::string, std::size_t> known{
        {"SCALARS", 1},    {"VECTORS", 3},      {"NORMALS", 3},
        {"TENSORS", 9},    {"TENSORS6", 6},     {"COLOR_SCALARS", 0},
        {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}, {"TEXTURE_COORDINATES", 0}};
    const auto found = known.find(key);
    if (found == known.end())
      text_.fail(words[0], "a section, such as POINTS, POINT_DATA, SCALARS, VECTORS or FIELD; or numbers too many");
    std::size_t components = found->second;
    if (components == 0) components = text_.count(words, 2);
    if (key == "SCALARS" && words.size() > 3) components = text_.count(words, 3);
    if (data_ == Data::of_file) text_.fail(words[0], "behind POINT_DATA or CELL_DATA");
    if (key == "SCALARS" && text_.is_before("LOOKUP_TABLE")) text_.words();
    const std::size_t place_of_type = key == "TEXTURE_COORDINATES" ? 3 : 2;
    const std::string_view type = key == "COLOR_SCALARS" ? "unsigned_char" : text_.word(words, place_of_type);
    keep(text_.numbers(decoded(text_.word(words, 1)), components, tuples_, type));
  }

  void read_field(const Words& words) {
    for (std::size_t arrays = text_.count(words, 2); arrays > 0;) {
      const Words array = text_.words();
      if (array.empty()) text_.fail("", fmt::format("{} more arrays of FIELD", arrays));
      if (array.size() == 1 && array[0] == "METADATA") {
        text_.skip_to_blank_line();
        continue;
      }
      if (array[0] != "NULL_ARRAY") read_array(array);
      --arrays;
    }
  }

  void read_array(const Words& words) {
    const std::size_t components = text_.count(words, 1), tuples = text_.count(words, 2);
    const std::string name = decoded(words[0]), type(text_.word(words, 3));
    if (type == "string" || type == "utf8_string") return text_.skip_strings(components * tuples);
    if (data_ == Data::of_points && tuples != points_)
      text_.fail(fmt::format("{} {}", name, tuples), fmt::format("of {} points", points_));
    std::vector<TableColumn> columns = text_.numbers(name, components, tuples, type);
    if (data_ != Data::of_file) return keep(std::move(columns));
    if (tuples == 0) return;
    const double value = columns.front().values.front();
    if (capital(name) == "TIME" || capital(name) == "TIMEVALUE") table_.time = value;
    if (capital(name) == "CYCLE" && std::abs(value) < 9e15 && value == std::round(value))
      table_.step = static_cast<std::int64_t>(value);
  }

  void keep(std::vector<TableColumn> columns) {
    if (data_ == Data::of_points)
      for (TableColumn& column : columns) table_.columns.push_back(std::move(column));
  }

  LegacyVtkText text_;
  ParticleTable table_;
  Data data_ = Data::of_file;
  std::size_t points_ = 0, tuples_ = 0;         ///< number of points; of tuples of an array of the data being read
  std::size_t offsets_ = 0, connectivity_ = 0;  ///< sizes of the arrays of the cells being read
};

}  // namespace

/// Reads the points and point data of POLYDATA or an UNSTRUCTURED_GRID in a legacy VTK file, as text or in binary. The
/// time and the step are those of its field data, TIME or TIMEVALUE and CYCLE, else the time that its title states.
ParticleTable read_legacy_vtk(const Source& source) {
  return LegacyVtk(source).table();
}

}  // namespace mpmvv::codes
