#pragma once
#include <string_view>
#include <vector>

#include "studies/codes/binary_number.hpp"
#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// A number in each of a file's records.
struct RecordField {
  std::string name;
  NumberType type;
  std::size_t offset;  ///< from the begin of the record, bytes
};

/// A column for each field, from records of `size` bytes that fill `bytes`.
std::vector<TableColumn> columns_of(std::string_view bytes, std::size_t size, const std::vector<RecordField>& fields,
                                    bool is_big_endian);

}  // namespace mpmvv::codes
