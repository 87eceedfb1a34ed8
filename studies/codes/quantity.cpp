#include "studies/codes/quantity.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <cctype>

namespace mpmvv::codes {

namespace {

/// An array and the names of its components, as patterns: {c} stands for the axes of a component in letters, {C} for
/// the same in capitals, {n} for their numbers from 1, {k} for the component's place in the array from 0.
struct Family {
  std::string array;
  std::size_t rank;
  std::vector<std::string> names;  ///< the first one is the word of the quantity
};

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"id", 0, {"id", "ID", "particle_id", "tag"}},
      {"X", 1, {"{C}", "{c}0", "X_{c}", "X:{k}", "reference:{k}", "reference_position:{k}"}},
      {"x", 1, {"{c}", "p{c}", "pos_{c}", "x_{c}", "x:{k}", "Points:{k}", "position:{k}"}},
      {"u", 1, {"u_{c}", "u{c}", "u:{k}", "displacement:{k}", "displacement_{c}"}},
      {"v", 1, {"v_{c}", "v{c}", "v:{k}", "velocity:{k}", "velocity_{c}"}},
      {"m", 0, {"m", "mass"}},
      {"V", 0, {"V", "volume"}},
      {"F", 2, {"F_{c}", "F{c}", "F{n}", "F:{k}", "deformation_gradient:{k}"}},
      {"s", 2, {"s_{c}", "s{c}", "s{n}", "sigma_{c}", "stress:{k}", "stress_{c}"}},
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
  return fmt::format(fmt::runtime(pattern), fmt::arg("c", c), fmt::arg("C", C), fmt::arg("n", n),
                     fmt::arg("k", 3 * i + j));
}

void add_components(const Family& family, std::vector<Quantity>& all) {
  if (family.rank == 0) return all.push_back({family.array, family.array, 0, family.names});
  for (std::size_t i = 0; i < (family.rank == 2 ? 3 : 1); ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Quantity quantity{"", family.array, 3 * i + j, {}};
      for (const std::string& pattern : family.names) quantity.usual.push_back(name_of(pattern, family.rank, i, j));
      if (family.array == "s" && i > j)
        for (const std::string& pattern : family.names) quantity.usual.push_back(name_of(pattern, family.rank, j, i));
      quantity.word = quantity.usual.front();
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

}  // namespace mpmvv::codes
