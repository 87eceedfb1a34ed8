#pragma once
#include <string_view>
#include <vector>

#include "studies/codes/binary_number.hpp"
#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// A number that each record of a file has.
struct RecordField {
  std::string name;
  NumberType type;
  std::size_t offset;  ///< from the beginning of the record, in bytes
};

/// Returns a column for each field. `bytes` has records of `size` bytes, one after the other.
std::vector<TableColumn> columns_of(std::string_view bytes, std::size_t size, const std::vector<RecordField>& fields,
                                    bool is_big_endian);

}  // namespace mpmvv::codes
