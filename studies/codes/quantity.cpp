#include "studies/codes/quantity.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <array>

namespace mpmvv::codes {

namespace {

/// An array, and the names of its components and of the array itself in files. The former are patterns: {c} stands for
/// the axes of a component in letters, {C} for the same in capitals, {n} for their numbers from 1.
struct Family {
  std::string array;
  std::size_t rank;
  std::vector<std::string> names;  ///< the first one is the word of the quantity
  std::vector<std::string> arrays = {};
};

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"id", 0, {"id", "ID", "particle_id", "tag"}},
      {"X", 1, {"{C}", "{c}0", "X_{c}"}, {"X", "reference", "reference_position"}},
      {"x", 1, {"{c}", "p{c}", "pos_{c}", "x_{c}", "Points_{C}"}, {"x", "Points", "position"}},
      {"u", 1, {"u_{c}", "u{c}", "displacement_{c}", "displacement_{C}"}, {"u", "displacement"}},
      {"v", 1, {"v_{c}", "v{c}", "velocity_{c}", "velocity_{C}"}, {"v", "velocity"}},
      {"m", 0, {"m", "mass"}},
      {"s", 2, {"s_{c}", "s{c}", "s{n}", "sigma_{c}", "stress_{c}", "stress_{C}"}, {"stress"}},
      {"time", 0, {"time", "t"}},
  };
  return all;
}

/// Returns the name of component i, j of a tensor, j of a vector.
std::string name_of(const std::string& pattern, std::size_t rank, std::size_t i, std::size_t j) {
  std::string c, C, n;
  for (const std::size_t axis : rank == 2 ? std::vector{i, j} : std::vector{j}) {
    c += "xyz"[axis];
    C += "XYZ"[axis];
    n += std::to_string(axis + 1);
  }
  return fmt::format(fmt::runtime(pattern), fmt::arg("c", c), fmt::arg("C", C), fmt::arg("n", n));
}

void add_components(const Family& family, std::vector<Quantity>& all) {
  if (family.rank == 0) return all.push_back({family.array, family.array, 0, "", family.names, {}});
  for (std::size_t i = 0; i < (family.rank == 2 ? 3 : 1); ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Quantity quantity{"", family.array, 3 * i + j, "", {}, family.arrays};
      for (const std::string& pattern : family.names) quantity.usual.push_back(name_of(pattern, family.rank, i, j));
      quantity.word = quantity.usual.front();
      if (family.rank == 2 && i != j) {
        quantity.mirror = name_of(family.names.front(), family.rank, j, i);
        for (const std::string& pattern : family.names) quantity.usual.push_back(name_of(pattern, family.rank, j, i));
      }
      all.push_back(quantity);
    }
}

}  // namespace

const std::vector<Quantity>& all_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> found;
    for (const Family& family : families()) add_components(family, found);
    return found;
  }();
  return all;
}

std::vector<Quantity> quantities_of(const std::string& array) {
  std::vector<Quantity> found;
  for (const Quantity& quantity : all_quantities())
    if (quantity.array == array) found.push_back(quantity);
  return found;
}

std::optional<std::size_t> place_in_array(const Quantity& quantity, std::size_t components) {
  constexpr std::array<std::size_t, 9> symmetric{0, 3, 5, 3, 1, 4, 5, 4, 2};
  if (quantity.array != "s" || quantity.component == 0 || components == 9) return quantity.component;
  if (components == 6) return symmetric[quantity.component];
  return std::nullopt;
}

}  // namespace mpmvv::codes
