#include "reports/particle_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reports/chart.hpp"
#include "studies/fits/median.hpp"

namespace mpmvv::reports {

using records::ParticleError;

namespace {

/// The particle and those around it: the eight nearest ones, and all that are as near as the eighth. Empty where it is
/// alone.
std::vector<Place> surroundings(const ParticleError& one, const std::vector<ParticleError>& all) {
  constexpr std::size_t ring = 8;
  constexpr double as_near = 1.01;  // a store has places with five digits
  const auto way_to = [&](const ParticleError& other) { return std::hypot(other.x - one.x, other.y - one.y); };
  std::vector<double> ways;
  for (const ParticleError& other : all)
    if (const double way = way_to(other); way > 0) ways.push_back(way);
  if (ways.empty()) return {};
  const auto last = ways.begin() + static_cast<std::ptrdiff_t>(std::min(ring, ways.size()) - 1);
  std::ranges::nth_element(ways, last);
  std::vector<Place> near{{0, 0}};
  for (const ParticleError& other : all)
    if (const double way = way_to(other); way > 0 && way <= as_near * *last)
      near.push_back({other.x - one.x, other.y - one.y});
  return near;
}

/// The spacing s of a lattice in a rectangle that has as many points and scatters as much as these do. k points along a
/// side have the variance s² (k² - 1) / 12; so (12 a + s²) (12 b + s²) = n² s⁴ for principal variances a and b.
double lattice_spacing(const std::vector<Place>& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const Place& p : points) x += p.x / n, y += p.y / n;
  for (const Place& p : points)
    xx += (p.x - x) * (p.x - x) / n, xy += (p.x - x) * (p.y - y) / n, yy += (p.y - y) * (p.y - y) / n;
  const double half_sum = 6 * (xx + yy), product = 144 * std::max(0.0, xx * yy - xy * xy), squares = n * n - 1;
  return std::sqrt((half_sum + std::sqrt(half_sum * half_sum + squares * product)) / squares);
}

/// The spacing where those around a particle are the eight of a square's ring, the farthest at its corners; not
/// measured where they lie on one side, at an edge, or in one or two rows.
double ring_spacing(const std::vector<Place>& near, double spacing) {
  constexpr double most_aside = 0.2, most_stretched = 2;
  constexpr std::size_t whole_ring = 9;
  double x = 0, y = 0, farthest = 0;
  for (const Place& p : near) {
    x += p.x / static_cast<double>(near.size()), y += p.y / static_cast<double>(near.size());
    farthest = std::max(farthest, std::hypot(p.x, p.y));
  }
  const double ring = farthest / std::sqrt(2);
  const bool is_ring =
      near.size() >= whole_ring && std::hypot(x, y) < most_aside * ring && ring < most_stretched * spacing;
  return is_ring ? ring : records::not_measured;
}

double reach_of(const ParticleError& lone) {
  const double reach = 2 * std::max(std::abs(lone.x), std::abs(lone.y));
  return reach > 0 ? reach : 1;
}

}  // namespace

double particle_spacing(const std::vector<ParticleError>& particles) {
  std::vector<double> spacings, rings;
  for (const ParticleError& one : particles) {
    const std::vector<Place> near = surroundings(one, particles);
    if (near.empty()) continue;
    spacings.push_back(lattice_spacing(near));
    if (const double ring = ring_spacing(near, spacings.back()); !std::isnan(ring)) rings.push_back(ring);
  }
  if (spacings.empty()) return reach_of(particles.front());
  return fits::median_of(rings.empty() ? spacings : rings);
}

}  // namespace mpmvv::reports
