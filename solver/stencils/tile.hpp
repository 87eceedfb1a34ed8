#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mpmvv::solver {

/// How many particles a tile holds on average, and at most: as many as stay in the nearer caches with all their fields.
inline constexpr int tile_size = 512;
inline constexpr int most_in_tile = 768;

/// The particles of neighbouring cells, in the order in which a sweep visits them: those that reach the same nodes, a
/// group, one after the other, wherever they are stored.
template <int D>
struct Tile {
  static constexpr int most = most_in_tile;
  static constexpr int room = most + 16;  ///< whole registers may be read at the last

  int count;                          ///< of particles
  int groups;                         ///< so many
  std::uint32_t particle[room];       ///< indices of the particles
  alignas(32) double xi[D][room];     ///< positions from the lower faces, in cells, where a basis may be evaluated
  alignas(32) double width[D][room];  ///< widths in cells, for bases that take one
  int first[room];                    ///< storage index of the first node that each reaches
  int group[most + 1];                ///< where each group begins, and the end

  /// Particles whose nodes are to be found.
  explicit Tile(std::span<const std::uint32_t> particles) : count(static_cast<int>(particles.size())) {
    std::ranges::copy(particles, particle);
    std::fill_n(particle + count, room - most, particle[count - 1]);
  }
};

}  // namespace mpmvv::solver
