#include <fmt/format.h>

#include <pugixml.hpp>

#include "studies/codes/readers.hpp"
#include "studies/codes/record_columns.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/codes/vtk_bytes.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

/// The XML of a file and its appended data, which may be binary and so no XML.
class VtkFile {
 public:
  explicit VtkFile(const Source& source) : file_(source.file) {
    const std::string_view content = source.content;
    if (content.starts_with("# vtk DataFile"))
      throw UsageError(fmt::format("a legacy VTK file in {} (VTK's XML; format vtk is the legacy one)", file_));
    const auto appended = content.find("<AppendedData");
    std::string text(content.substr(0, appended));
    if (appended != std::string_view::npos) {
      cut_appended(content.substr(appended));
      text += "</VTKFile>";
    }
    if (const auto result = document_.load_string(text.c_str()); !result)
      fail(fmt::format("no XML: {} at byte {}", result.description(), result.offset));
    const pugi::xml_node root = document_.child("VTKFile");
    packing_ = {.is_big_endian = root.attribute("byte_order").as_string() == std::string_view("BigEndian"),
                .header_size = root.attribute("header_type").as_string() == std::string_view("UInt64") ? 8U : 4U,
                .is_compressed = !root.attribute("compressor").empty(),
                .file = source.file};
    const std::string_view compressor = root.attribute("compressor").as_string("vtkZLibDataCompressor");
    if (compressor != "vtkZLibDataCompressor")
      fail(fmt::format("compressor '{}' (known: vtkZLibDataCompressor)", compressor));
    data_ = root.first_child();
    while (data_ && !data_.child("Piece")) data_ = data_.next_sibling();
    if (!data_) fail("no Piece");
  }

  pugi::xml_node data() const { return data_; }  ///< the element that has the pieces: UnstructuredGrid or PolyData

  /// Returns the numbers of an array as columns, one for each component.
  std::vector<TableColumn> columns(pugi::xml_node array, const std::string& name) const {
    const std::size_t components = array.attribute("NumberOfComponents").as_uint(1);
    if (components == 0 || components > 100) fail(fmt::format("{} components of '{}', not 1 to 100", components, name));
    const auto name_of = [&](std::size_t k) { return components == 1 ? name : fmt::format("{}:{}", name, k); };
    const std::string_view format = array.attribute("format").as_string("ascii");
    const auto type = number_type(array.attribute("type").as_string());
    if (!type) fail(fmt::format("type '{}' of '{}'", array.attribute("type").as_string(), name));
    if (format == "ascii") return texts(array.text().get(), components, name, name_of);
    const std::string bytes = format == "appended" ? unpacked(appended(array), appended_encoding_, packing_)
                                                   : unpacked(array.text().get(), VtkEncoding::base64, packing_);
    std::vector<RecordField> fields;
    for (std::size_t k = 0; k < components; ++k) fields.push_back({name_of(k), *type, k * type->size});
    return columns_of(bytes, components * type->size, fields, packing_.is_big_endian);
  }

  [[noreturn]] void fail(const std::string& what) const { throw UsageError(fault(what)); }
  std::string fault(const std::string& what) const {
    return fmt::format("{} in {} (a VTK file in XML: .vtu or .vtp)", what, file_);
  }

 private:
  void cut_appended(std::string_view rest) {
    const auto end_of_tag = rest.find('>');
    const std::string_view tag = rest.substr(0, end_of_tag);
    const auto begin = end_of_tag == std::string_view::npos ? end_of_tag : rest.find('_', end_of_tag);
    if (begin == std::string_view::npos) fail("no _ before the appended data");
    appended_ = rest.substr(begin + 1);
    if (tag.find("base64") != std::string_view::npos) appended_encoding_ = VtkEncoding::base64;
  }

  /// Returns the appended data from where the array begins.
  std::string_view appended(pugi::xml_node array) const {
    const auto offset = array.attribute("offset").as_ullong();
    if (offset >= appended_.size()) fail(fmt::format("offset {} behind the appended data", offset));
    return appended_.substr(offset);
  }

  template <class NameOf>
  std::vector<TableColumn> texts(std::string_view text, std::size_t components, const std::string& name,
                                 const NameOf& name_of) const {
    constexpr std::string_view blanks = " \t\r\n";
    std::vector<TableColumn> columns(components);
    for (std::size_t k = 0; k < components; ++k) columns[k].name = name_of(k);
    for (std::size_t k = 0; !(text = text.substr(std::min(text.find_first_not_of(blanks), text.size()))).empty();
         k = (k + 1) % components) {
      const std::string_view number = text.substr(0, text.find_first_of(blanks));
      if (!add_text(columns[k], number)) fail(fmt::format("'{}' for '{}'", number.substr(0, 40), name));
      text.remove_prefix(number.size());
    }
    return columns;
  }

  std::string file_;
  pugi::xml_document document_;
  pugi::xml_node data_;
  VtkPacking packing_;
  std::string_view appended_;
  VtkEncoding appended_encoding_ = VtkEncoding::raw;
};

/// Returns the columns of the arrays of a piece. It reads no array behind one whose numbers are not those of the
/// points: arrays that share their bytes may together need far more memory than the file has.
std::vector<TableColumn> columns_of_piece(const VtkFile& file, pugi::xml_node piece) {
  const std::size_t points = piece.attribute("NumberOfPoints").as_ullong();
  std::vector<TableColumn> columns;
  const auto add = [&](pugi::xml_node array, const std::string& name) {
    for (TableColumn& column : file.columns(array, name)) {
      if (column.values.size() != points)
        file.fail(fmt::format("{} numbers in '{}' of {} points", column.values.size(), column.name, points));
      columns.push_back(std::move(column));
    }
  };
  add(piece.child("Points").child("DataArray"), "Points");
  for (const pugi::xml_node array : piece.child("PointData").children("DataArray"))
    add(array, array.attribute("Name").as_string());
  return columns;
}

/// Appends the arrays of a piece to those of the pieces before it.
void add_piece(const VtkFile& file, pugi::xml_node piece, ParticleTable& table) {
  const bool is_first = table.columns.empty();
  std::vector<TableColumn> columns = columns_of_piece(file, piece);
  if (is_first) table.columns.resize(columns.size());
  if (columns.size() != table.columns.size()) file.fail("pieces with other arrays than the first");
  for (std::size_t k = 0; k < columns.size(); ++k) {
    TableColumn& all = table.columns[k];
    if (is_first)
      all = std::move(columns[k]);
    else if (all.name != columns[k].name)
      file.fail("pieces with other arrays than the first");
    else
      append(all, columns[k]);
  }
}

}  // namespace

/// Reads the points of an unstructured grid or of poly data, as text, base64 or appended data, with zlib or without.
ParticleTable read_vtu(const Source& source) {
  const VtkFile file(source);
  ParticleTable table;
  for (const pugi::xml_node piece : file.data().children("Piece"))
    if (piece.attribute("NumberOfPoints").as_ullong() > 0) add_piece(file, piece, table);
  if (table.columns.empty()) throw NoParticles(file.fault("no points"));
  for (const pugi::xml_node array : file.data().child("FieldData").children("DataArray")) {
    const std::string name = array.attribute("Name").as_string();
    if (name != "TimeValue" && name != "TIME" && name != "time") continue;
    const auto columns = file.columns(array, name);
    if (!columns.front().values.empty()) table.time = columns.front().values.front();
  }
  return table;
}

}  // namespace mpmvv::codes
