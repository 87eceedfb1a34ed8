#include "studies/codes/record_columns.hpp"

namespace mpmvv::codes {

std::vector<TableColumn> columns_of(std::string_view bytes, std::size_t size, const std::vector<RecordField>& fields,
                                    bool is_big_endian) {
  std::vector<TableColumn> columns;
  for (const RecordField& field : fields) {
    TableColumn column{.name = field.name, .bits = field.type.bits()};
    column.values.reserve(bytes.size() / size);
    for (std::size_t at = 0; at + size <= bytes.size(); at += size)
      column.values.push_back(number_at(bytes.data() + at + field.offset, field.type, is_big_endian));
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace mpmvv::codes
