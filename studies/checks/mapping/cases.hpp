#pragma once
#include <string>

#include "studies/checks/mapping/mapped_body.hpp"

/// The bodies on which the properties are measured: blocks of particles inside a wider grid of unit cells.
namespace mpmvv::checks::mapping {

enum class Placement { uniform, translated, random };

inline constexpr std::array placements{Placement::uniform, Placement::translated, Placement::random};

inline const std::array<Weighting, 3> weightings{dirac, gimp, spline};

/// A block of 12 cells of 3 particles in one dimension, or of 8 x 8 cells of 2 x 2 in two, with four empty cells on
/// either side. `uniform` is aligned with the grid and has unit density. `translated` is the same, moved by a part of a
/// cell. `random` has boxes of random sizes, is aligned at the faces of the block, and its density grows to three times
/// (1D) or five times (2D) its least value.
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
