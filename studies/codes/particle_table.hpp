#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// A column of a file in the file's own unit. Component k of an array with several components is named `array:k`, as
/// ParaView names it.
struct TableColumn {
  std::string name;
  std::vector<double> values = {};
  int digits = 0;          ///< the largest number of significant digits in a text; 0 for binary numbers
  int decimals = -1;       ///< digits behind the point, if all texts show as many and no exponent; -1 otherwise
  bool is_padded = false;  ///< whether a text shows several decimals, the last of them 0: the shortest text has no such
  int bits = 0;            ///< size of the mantissa of binary numbers, 24 or 53; 0 for texts and whole numbers
};

/// Appends the values of one column to those of another.
inline void append(TableColumn& all, const TableColumn& more) {
  all.values.insert(all.values.end(), more.values.begin(), more.values.end());
  all.digits = std::max(all.digits, more.digits);
  if (all.decimals != more.decimals) all.decimals = -1;
  all.is_padded = all.is_padded || more.is_padded;
  if (more.bits > 0) all.bits = more.bits;
}

/// What a reader takes from a file: columns of equal length.
struct ParticleTable {
  std::vector<TableColumn> columns;
  std::optional<double> time;               ///< the time of the state, in the file's unit
  bool is_time_in_seconds = false;          ///< whether the file states seconds behind the time, whatever its unit is
  std::optional<std::int64_t> step = {};    ///< number of time steps before this state
  std::vector<std::size_t> lines = {};      ///< the line of each row in a text, from 1
  std::map<std::string, std::string> says;  ///< keys and values from comments

  const TableColumn* find(const std::string& name) const {
    for (const TableColumn& column : columns)
      if (column.name == name) return &column;
    return nullptr;
  }
};

}  // namespace mpmvv::codes
