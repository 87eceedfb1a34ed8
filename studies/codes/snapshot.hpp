#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::codes {

using Point = std::array<double, 3>;
using Tensor = std::array<double, 9>;  ///< row by row

/// What a code wrote of its particles at one time. SI units. Each list has an entry for each particle, in the order of
/// the file, or none at all where the file has nothing of the kind. Coordinates that the file lacks are 0.
struct Snapshot {
  std::string file;
  std::optional<double> time = {};
  std::optional<std::int64_t> step = {};  ///< how many time steps there were before it
  std::vector<std::int64_t> id = {};      ///< of the particle: 1, 2, ... in the order in which they fill the body
  std::vector<Point> X = {}, x = {}, u = {}, v = {};  ///< reference position, position, displacement, velocity
  std::vector<double> mass = {}, volume = {};
  std::vector<Tensor> F = {}, stress = {};  ///< deformation gradient; Cauchy stress
  int digits = 17;      ///< that its numbers carry; 7 and 16 of binary ones in single and double precision
  double rounding = 0;  ///< RMS over particles of a position's unit in the last place, m; of u where that is written
  std::map<std::string, std::string> says = {};  ///< what else it says of its run: `problem`, `cells`, ...

  std::size_t size() const { return x.empty() ? u.size() : x.size(); }
};

}  // namespace mpmvv::codes
