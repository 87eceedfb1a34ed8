#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "studies/codes/particle_table.hpp"
#include "studies/codes/snapshot.hpp"

namespace mpmvv::codes {

/// Where a code's file keeps what, and in which units.
struct Columns {
  /// The column of a quantity, by name or by number from 1 on. Quantities are words of `all_quantities()`; names of
  /// arrays (X, x, u, v, F, s) stand for all components of an array. What is not named here is looked for by usual
  /// names.
  std::map<std::string, std::string> names = {};
  std::string where = "--columns";        ///< what names them
  double length = 1, time = 1, mass = 1;  ///< m, s and kg to the file's unit
  std::optional<std::int64_t> step = {};  ///< which one, where a file has several; none: the last
  std::size_t dimensions = 0;  ///< of the case: it needs as many components, and no others; 0: as many as there are
};

/// "id=tag,x=px" as pairs; UsageError, with `where`, of what is none or names no quantity.
std::map<std::string, std::string> parse_columns(const std::string& text, const std::string& where);

/// The column of this name; null where there is none, UsageError where there are two.
const TableColumn* only_column(const ParticleTable& table, const std::string& name, const std::string& file);

/// The table's columns by their quantities. UsageError when a column that was named is not there, when there is neither
/// position nor displacement, or not every component of something that there is.
Snapshot snapshot_of(const ParticleTable& table, const Columns& columns, const std::string& file);

}  // namespace mpmvv::codes
