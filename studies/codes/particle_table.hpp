#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// A column of a file as it stands there, whatever its unit. Component k of an array with several of them is named
/// `array:k`, as ParaView does.
struct TableColumn {
  std::string name;
  std::vector<double> values = {};
  int digits = 0;     ///< the most significant digits of a text; 0 of binary numbers
  int decimals = -1;  ///< behind the point where all texts have as many, and no exponent; -1 otherwise
  int bits = 0;       ///< of a binary number's mantissa: 24 or 53; 0 of texts and whole numbers
};

/// Puts the values of one column behind those of another.
inline void append(TableColumn& all, const TableColumn& more) {
  all.values.insert(all.values.end(), more.values.begin(), more.values.end());
  all.digits = std::max(all.digits, more.digits);
  if (all.decimals != more.decimals) all.decimals = -1;
  if (more.bits > 0) all.bits = more.bits;
}

/// What a reader takes from a file: columns of equal length.
struct ParticleTable {
  std::vector<TableColumn> columns;
  std::optional<double> time;               ///< in the file's unit
  std::optional<std::int64_t> step = {};    ///< time steps before it
  std::vector<std::size_t> lines = {};      ///< of the rows of a text, counted from 1
  std::map<std::string, std::string> says;  ///< pairs of a key and its value, as comments carry them

  const TableColumn* find(const std::string& name) const {
    for (const TableColumn& column : columns)
      if (column.name == name) return &column;
    return nullptr;
  }
};

}  // namespace mpmvv::codes
