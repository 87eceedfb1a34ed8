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

/// One of the files that a state was read from, how many of its particles are in it, and what its comments say.
struct SnapshotPart {
  std::string file;
  std::size_t rows;
  std::map<std::string, std::string> says = {};
};

/// The particles that a code wrote at one time. SI units. Each list has an entry for each particle, in the order of the
/// file, or is empty if the file has no such quantity. Components that the file lacks are 0.
struct Snapshot {
  std::string file;                      ///< for messages; of several files the first, with the number of the others
  std::vector<SnapshotPart> parts = {};  ///< these files; empty if it is one
  std::optional<double> time = {};
  std::optional<std::int64_t> step = {};  ///< number of time steps before this state
  std::vector<std::int64_t> id = {};      ///< particles counted from 1 as they fill the body, or the code's own ids
  std::vector<Point> X = {}, x = {}, u = {}, v = {};  ///< reference position, position, displacement, velocity
  std::vector<double> mass = {};                      ///< of a plane body per metre of thickness
  std::vector<Tensor> stress = {};                    ///< Cauchy stress
  int digits = 17;      ///< significant digits of the positions; 7 and 16 in single and double precision
  double rounding = 0;  ///< the unit in the last place of a position, or of u if that is written: RMS over particles, m
  double rounding_of_all =
      0;  ///< the same of x - X - u, from the digits that these show; 0 unless all three are written
  std::map<std::string, std::string> says = {};  ///< what comments, of the first file, say of the run: `problem`, ...
  bool has_own_units = false;  ///< whether the file's units are not m, s and kg: numbers of comments may be in these

  std::size_t size() const { return x.empty() ? u.size() : x.size(); }
  void leave_out(const std::string& key);  ///< forgets what comments say of the key
};

/// Names a particle so that it is found in the file: by its id, else by its row, of several files with the one.
std::string name_of_particle(const Snapshot& s, std::size_t row);

}  // namespace mpmvv::codes
