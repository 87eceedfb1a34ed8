#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "studies/codes/particle_table.hpp"
#include "studies/codes/snapshot.hpp"

namespace mpmvv::codes {

/// Which columns of a code's file have which quantities, and the file's units.
struct Columns {
  /// For a quantity, the name or the number (from 1) of its column. Quantities are words of `all_quantities()`; the
  /// names of arrays (X, x, u, v, s) stand for all their components. Quantities that are not named here are looked for
  /// by their usual names; s_yx, if s_xy is named, by that name. Names for V and F are allowed, and not read.
  std::map<std::string, std::string> names = {};
  std::string where = "--columns";        ///< what gave the names, for messages
  double length = 1, time = 1, mass = 1;  ///< the file's units in m, s and kg
  double thickness = 1;                   ///< of the body in m; in two dimensions masses are divided by it
  std::optional<std::int64_t> step = {};  ///< the time step to read if the file has several; nullopt: the last
  std::size_t dimensions = 0;  ///< axes of the case: only their components are read, all are needed; 0: not known
};

/// Returns the pairs of a text such as "id=tag,x=px". Throws UsageError, which says `where`, for a part that is no pair
/// or names no quantity.
std::map<std::string, std::string> parse_columns(const std::string& text, const std::string& where);

/// Returns the column with this name, null if there is none. Throws UsageError if there are several.
const TableColumn* only_column(const ParticleTable& table, const std::string& name, const std::string& file);

/// Returns the table's columns by their quantities, in SI units. Throws UsageError if a column that was named is
/// missing, if there is neither position nor displacement, if an array lacks a component that the case has or has so
/// many that their order is not known, if an id is no whole number, if rows have different times, or if a reference
/// position alone is no number.
Snapshot snapshot_of(const ParticleTable& table, const Columns& columns, const std::string& file);

}  // namespace mpmvv::codes
