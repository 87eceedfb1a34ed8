#pragma once
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "studies/checks/profiles/particle_panel.hpp"

namespace mpmvv::checks::profiles {

/// A quantity along x, with a point for each column of particles of the lattice: means over the column.
struct Profile {
  std::vector<double> x;  ///< mean current positions
  std::vector<double> y;
};

/// Returns the profile of value(p) over the particles p of a body filled by a lattice.
template <int D, class Value>
Profile profile(const MovingBody<D>& body, const Value& value) {
  struct Column {
    double x = 0, y = 0, count = 0;
  };
  std::map<long long, Column> columns;  // by reference position, in units far below a particle's width
  const auto& particles = body.mpm().particles();
  const double unit = 1e-3 * body.mpm().grid().h();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    Column& column = columns[std::llround(body.X()[particles.id[p]][0] / unit)];
    const double count = body.count_of(particles.id[p]);
    column.x += count * particles.x[p][0], column.y += count * value(p), column.count += count;
  }
  Profile result;
  for (const auto& [place, column] : columns)
    result.x.push_back(column.x / column.count), result.y.push_back(column.y / column.count);
  return result;
}

}  // namespace mpmvv::checks::profiles
