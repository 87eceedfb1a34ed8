#pragma once
#include <string>

#include "studies/checks/mapping/mapped_body.hpp"

/// The bodies on which the properties are measured: a block of particles amid a wider grid of unit cells.
namespace mpmvv::checks::mapping {

enum class Placement { uniform, translated, random };

inline constexpr std::array placements{Placement::uniform, Placement::translated, Placement::random};

inline const std::array<Weighting, 3> weightings{dirac, gimp, spline};

/// 12 cells of 3 particles in one dimension, 8 x 8 cells of 2 x 2 in two, and four empty cells on either side. Uniform:
/// aligned with the grid, unit density; translated: the same, moved by a part of a cell; random: boxes of random sizes,
/// aligned at the block's faces, density growing to the three- or fivefold.
template <int D>
struct BlockOfParticles {
  static constexpr int cells = D == 1 ? 12 : 8, ppc = D == 1 ? 3 : 2, empty = 4;

  static OverlayGrid<D> grid() {
    OverlayGrid<D> grid{solver::Vec<D>::Zero(), solver::Vec<D>::Ones(), {}};
    grid.cells.fill(cells + 2 * empty);
    return grid;
  }

  static ParticleTiling<D> tiling(Placement placement) {
    const solver::Vec<D> lower = solver::Vec<D>::Constant(empty), extent = solver::Vec<D>::Constant(cells);
    solver::Index<D> count;
    count.fill(cells * ppc);
    if (placement == Placement::random) return random_tiling<D>(lower, extent, count, 165);
    const auto aligned = uniform_tiling<D>(lower, extent, count);
    const double shift = D == 1 ? 0.1 : 0.35;
    return placement == Placement::uniform ? aligned : aligned.translated(solver::Vec<D>::Constant(shift));
  }

  static std::string name(Placement placement, const Weighting& weighting) {
    constexpr std::array words{"uniform", "translated", "random"};
    return std::string(weighting.name) + ", " + words[static_cast<std::size_t>(placement)] + (D == 1 ? ", 1D" : ", 2D");
  }
};

}  // namespace mpmvv::checks::mapping
