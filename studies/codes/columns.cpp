#include "studies/codes/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "studies/codes/quantity.hpp"
#include "studies/codes/rounding.hpp"
#include "studies/codes/text_lines.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

namespace {

std::vector<std::string> known_columns(const ParticleTable& table) {
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(column.name);
  return names;
}

/// Finds the column of a quantity.
class Lookup {
 public:
  Lookup(const ParticleTable& table, const Columns& columns, const std::string& file)
      : table_(table), columns_(columns), file_(file) {}

  /// Returns the components of an array that the case has; all of them if its dimension is not known.
  std::vector<Quantity> needed(const std::string& array) const {
    std::vector<Quantity> all = quantities_of(array);
    if (const std::size_t D = columns_.dimensions; D > 0)
      std::erase_if(all, [D](const Quantity& q) { return q.component / 3 >= D || q.component % 3 >= D; });
    return all;
  }

  /// Throws UsageError if the file has some components of an array that the case has, but not all. `found` is the word
  /// of a component that the file has, `missing` of one that it lacks; empty if there is none.
  void require_whole(const std::string& found, const std::string& missing) const {
    if (columns_.dimensions == 0 || found.empty() || missing.empty()) return;
    throw UsageError(
        fmt::format("no column for {} in {}, which has one for {} (its columns: {}; --columns, or `columns` in an "
                    "adapter, says which it is)",
                    missing, file_, found, fmt::join(known_columns(table_), ", ")));
  }

  /// Returns the column of a quantity; null if the file has none. Throws UsageError if a column that was named, or the
  /// first component of an array that was named, is not in the file.
  const TableColumn* find(const Quantity& quantity) const {
    for (const std::string& word : {quantity.word, quantity.mirror})
      if (const auto given = columns_.names.find(word); given != columns_.names.end())
        if (const TableColumn* column = named(given->second, quantity)) return column;
    if (const auto given = columns_.names.find(quantity.array); given != columns_.names.end()) {
      const TableColumn* column = column_in(given->second, quantity);
      if (!column && quantity.component == 0) fail(given->second, quantity.array);
      if (column || column_of(given->second + ":0")) return column;  // else it is the column of the first component
    }
    for (const std::string& name : quantity.usual)
      if (const TableColumn* column = column_of(name); column && !is_of_another(*column, quantity)) return column;
    for (const std::string& array : quantity.arrays)
      if (const TableColumn* column = column_in(array, quantity); column && !is_of_another(*column, quantity))
        return column;
    return nullptr;
  }

 private:
  const TableColumn* column_of(const std::string& name) const { return only_column(table_, name, file_); }

  /// Returns the column of a quantity in the array with this name, whose columns are `NAME:0`, ...; null if it has
  /// none. Throws UsageError if nothing says in which order an array of so many components has them.
  const TableColumn* column_in(const std::string& array, const Quantity& quantity) const {
    const auto is_component = [start = array + ":"](const TableColumn& column) {
      const std::string& name = column.name;
      return name.starts_with(start) && name.find_first_not_of("0123456789", start.size()) == std::string::npos;
    };
    const auto components = static_cast<std::size_t>(std::ranges::count_if(table_.columns, is_component));
    if (components == 0) return nullptr;
    if (const auto place = place_in_array(quantity, components)) return column_of(fmt::format("{}:{}", array, *place));
    throw UsageError(fmt::format(
        "array '{}' of {} components in {} (9, row by row, or 6 as VTK orders them: xx, yy, zz, xy, yz, xz; "
        "else {}={}:0,... in --columns, or `columns` in an adapter, says which is which)",
        array, components, file_, quantities_of(quantity.array).front().word, array));
  }

  /// Returns the column with this name, else with this number; null if there is none.
  const TableColumn* by_name_or_number(const std::string& name) const {
    if (const TableColumn* column = column_of(name)) return column;
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool is_number = stop == name.data() + name.size() && number >= 1 && number <= table_.columns.size();
    return is_number ? &table_.columns[number - 1] : nullptr;
  }

  /// Whether a column was named for another quantity: it then is not this one, whatever it is called.
  bool is_of_another(const TableColumn& column, const Quantity& quantity) const {
    return std::ranges::any_of(columns_.names, [&](const auto& given) {
      const auto& [word, name] = given;
      if (word == quantity.word || word == quantity.array || word == quantity.mirror) return false;
      return by_name_or_number(name) == &column || column.name.starts_with(name + ":");
    });
  }

  /// Returns the column with this name, else with this number; null if it is the name of an array, with columns
  /// `NAME:0`, ... Throws UsageError otherwise.
  const TableColumn* named(const std::string& name, const Quantity& quantity) const {
    if (const TableColumn* column = by_name_or_number(name)) return column;
    if (quantity.word == quantity.array && column_of(name + ":0")) return nullptr;
    fail(name, quantity.word);
  }

  [[noreturn]] void fail(const std::string& name, const std::string& word) const {
    throw UsageError(fmt::format("unknown column '{}' for {} in {}, named by {} (known: {})", name, word, file_,
                                 columns_.where, fmt::join(known_columns(table_), ", ")));
  }

  const ParticleTable& table_;
  const Columns& columns_;
  const std::string& file_;
};

/// Returns the components of an array of each particle, times `scale`; 0 for those that the case or the file lacks.
/// Empty if the file has none of them.
template <std::size_t N>
std::vector<std::array<double, N>> components(const Lookup& lookup, const std::string& array, double scale) {
  std::vector<std::array<double, N>> all;
  std::string found, missing;
  for (const Quantity& quantity : lookup.needed(array)) {
    const TableColumn* column = lookup.find(quantity);
    std::string& word = column ? found : missing;
    if (word.empty()) word = quantity.word;
    if (!column) continue;
    all.resize(column->values.size());
    for (std::size_t p = 0; p < all.size(); ++p) all[p][quantity.component] = scale * column->values[p];
  }
  lookup.require_whole(found, missing);
  return all;
}

/// Returns the columns of the components of these arrays.
std::vector<const TableColumn*> columns_holding(const Lookup& lookup, const std::vector<std::string>& arrays) {
  std::vector<const TableColumn*> all;
  for (const std::string& array : arrays)
    for (const Quantity& quantity : lookup.needed(array))
      if (const TableColumn* column = lookup.find(quantity)) all.push_back(column);
  return all;
}

std::vector<double> scalars(const Lookup& lookup, const std::string& word, double scale) {
  const TableColumn* column = lookup.find(quantities_of(word).front());
  if (!column) return {};
  std::vector<double> values = column->values;
  for (double& value : values) value *= scale;
  return values;
}

std::vector<std::int64_t> ids(const Lookup& lookup, const std::string& file) {
  std::vector<std::int64_t> all;
  for (const double value : scalars(lookup, "id", 1)) {
    if (!(std::abs(value) < 9e15) || value != std::round(value))
      throw UsageError(fmt::format("id {} of a particle in {} (a whole number)", value, file));
    all.push_back(static_cast<std::int64_t>(value));
  }
  return all;
}

/// Returns the time in s, from a header or comment, or else from a column. All of them and every row must say the same,
/// to the digits that a comment may have. Beside a header a column `t` may be a temperature. `scale` is the file's unit
/// of time in s.
std::optional<double> time_of(const ParticleTable& table, const Lookup& lookup, double scale, const std::string& file) {
  const TableColumn* column = lookup.find(quantities_of("time").front());
  if (column && table.time && column->name == "t") column = nullptr;
  std::optional<double> stated = table.time;
  if (stated && table.is_time_in_seconds) *stated /= scale;
  if (!column || column->values.empty()) return stated ? std::optional(scale * *stated) : std::nullopt;
  const double first = column->values.front(), time = stated.value_or(first);
  if (std::ranges::any_of(column->values, [first](double t) { return t != first; }))
    throw UsageError(fmt::format("several times in {} (one)", file));
  if (!(std::abs(first - time) <= 1e-4 * std::abs(time)))
    throw UsageError(
        fmt::format("time {} in {}, and {} in its column '{}' (one time)", time, file, first, column->name));
  return scale * time;
}

/// Whether a word names a number that no measure needs: the volume, or a component of the deformation gradient. Columns
/// may be named for them, and are not read.
bool is_unread(const std::string& word) {
  return word == "V" || word == "F" ||
         (word.size() == 4 && word.starts_with("F_") && word.find_first_not_of("xyz", 2) == std::string::npos);
}

/// Returns the words of all quantities and arrays, each once.
std::vector<std::string> known_words() {
  std::vector<std::string> words;
  for (const Quantity& quantity : all_quantities())
    for (const std::string& word : {quantity.array, quantity.word})
      if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  return words;
}

/// Throws UsageError if a particle's position and displacement are finite but its reference position is not. A particle
/// of which these are not finite either is lost, which is a result.
void require_reference_positions(const Snapshot& s, const std::string& file) {
  const auto is_number = [](const std::vector<Point>& all, std::size_t row) {
    return all.empty() || std::ranges::all_of(all[row], [](double d) { return std::isfinite(d); });
  };
  for (std::size_t row = 0; row < s.X.size(); ++row)
    if (!is_number(s.X, row) && is_number(s.x, row) && is_number(s.u, row))
      throw UsageError(fmt::format(
          "the reference position of row {} in {} is no number (where the particle is at rest)", row + 1, file));
}

}  // namespace

std::map<std::string, std::string> parse_columns(const std::string& text, const std::string& where) {
  std::map<std::string, std::string> names;
  for (const std::string_view pair : fields_of(text, ',')) {
    const auto middle = pair.find('=');
    if (middle == std::string_view::npos || middle == 0 || middle + 1 == pair.size())
      throw UsageError(fmt::format("'{}' in {} (quantity=column, as in id=tag,x=px)", pair, where));
    const std::string word(pair.substr(0, middle));
    const auto known = known_words();
    if (std::find(known.begin(), known.end(), word) == known.end() && !is_unread(word))
      throw UsageError(fmt::format("unknown quantity '{}' in {} (known: {})", word, where, fmt::join(known, ", ")));
    names[word] = pair.substr(middle + 1);
  }
  return names;
}

const TableColumn* only_column(const ParticleTable& table, const std::string& name, const std::string& file) {
  const auto count = std::ranges::count(table.columns, name, &TableColumn::name);
  if (count > 1) throw UsageError(fmt::format("{} columns '{}' in {} (one)", count, name, file));
  return table.find(name);
}

Snapshot snapshot_of(const ParticleTable& table, const Columns& columns, const std::string& file) {
  const Lookup lookup(table, columns, file);
  const double length = columns.length, speed = columns.length / columns.time;
  const double pressure = columns.mass / columns.length / columns.time / columns.time;
  Snapshot s{.file = file,
             .time = time_of(table, lookup, columns.time, file),
             .step = table.step,
             .id = ids(lookup, file),
             .X = components<3>(lookup, "X", length),
             .x = components<3>(lookup, "x", length),
             .u = components<3>(lookup, "u", length),
             .v = components<3>(lookup, "v", speed),
             .mass = scalars(lookup, "m", columns.dimensions == 2 ? columns.mass / columns.thickness : columns.mass),
             .stress = components<9>(lookup, "s", pressure),
             .says = table.says,
             .has_own_units = columns.length != 1 || columns.time != 1 || columns.mass != 1};
  if (s.x.empty() && s.u.empty()) {
    throw UsageError(fmt::format("no positions in {} (columns x, y, z, or --columns x=...; it has {})", file,
                                 fmt::join(known_columns(table), ", ")));
  }
  require_reference_positions(s, file);
  const Rounding rounding = rounding_of(table, columns_holding(lookup, {s.u.empty() ? "x" : "u"}));
  s.digits = rounding.digits;
  s.rounding = length * rounding.unit;
  if (!s.X.empty() && !s.x.empty() && !s.u.empty())
    s.rounding_of_all =
        length * (unit_shown_by(columns_holding(lookup, {"X", "x"})) + unit_shown_by(columns_holding(lookup, {"u"})));
  return s;
}

}  // namespace mpmvv::codes
