#include <cmath>

#include "studies/checks/extremes.hpp"
#include "studies/checks/profiles/particle_panel.hpp"

namespace mpmvv::checks {

namespace {

constexpr int per_cell = 4;

using Vec = solver::Vec<3>;

/// Centres and widths of the voxels by particle id: n along each axis, the first axis fastest.
struct Voxels {
  std::size_t n;
  std::vector<Vec> centre, width;
};

Voxels voxels_of(const solver::Mpm<3>& mpm, int cells) {
  const auto& particles = mpm.particles();
  Voxels voxels{static_cast<std::size_t>(cells * per_cell), {}, {}};
  voxels.centre.resize(particles.size()), voxels.width.resize(particles.size());
  for (std::size_t p = 0; p < particles.size(); ++p) {
    voxels.centre[particles.id[p]] = particles.x[p];
    voxels.width[particles.id[p]] = particles.l[p] * mpm.grid().h();
  }
  return voxels;
}

/// Returns the voxels that follow from the positions and deformation gradients of the exact solution.
Voxels exact_voxels_of(const profiles::MovingBody<3>& motion, int cells) {
  Voxels voxels{static_cast<std::size_t>(cells * per_cell), {}, {}};
  for (const Vec& X : motion.X()) {
    voxels.centre.emplace_back(X + motion.solution().u(X, motion.mpm().time()));
    voxels.width.emplace_back(motion.solution().F(X, motion.mpm().time()).diagonal() / (cells * per_cell));
  }
  return voxels;
}

/// How far the voxels are from tiling the body, which fills the unit cube.
struct Tiling {
  double volume_error = 0;  ///< difference of the total volume of the voxels and the volume of the body
  double gap = 0;           ///< largest gap or overlap of neighbours along the axis between them, or to a face
  double offset = 0;        ///< largest offset of the centres of neighbours across the axis between them
};

Tiling tiling_of(const Voxels& voxels) {
  Tiling tiling;
  double volume = 0;
  const auto note_gap = [&](double gap) { keep_larger(tiling.gap, std::abs(gap)); };
  for (std::size_t p = 0; p < voxels.centre.size(); ++p) {
    volume += voxels.width[p].prod();
    std::size_t stride = 1;
    for (int d = 0; d < 3; ++d, stride *= voxels.n) {
      const std::size_t place = p / stride % voxels.n;
      const double upper = voxels.centre[p][d] + voxels.width[p][d] / 2;
      if (place == 0) note_gap(voxels.centre[p][d] - voxels.width[p][d] / 2);
      if (place + 1 == voxels.n) {
        note_gap(1 - upper);
        continue;
      }
      const std::size_t q = p + stride;
      note_gap(voxels.centre[q][d] - voxels.width[q][d] / 2 - upper);
      Vec across = voxels.centre[q] - voxels.centre[p];
      across[d] = 0;
      keep_larger(tiling.offset, largest_of(across.cwiseAbs()));
    }
  }
  tiling.volume_error = std::abs(volume - 1);
  return tiling;
}

}  // namespace

/// Measures how well the voxels of the cube tile it at t = 0.005, when the displacement along x is largest, S Fig. 13.
CheckResult check_cube_voxels() {
  CheckResult result;
  double coarse_gap = 0;
  for (const int cells : {8, 16}) {
    profiles::MovingBody<3> motion({{"problem", "cube", ""},
                                    {"basis", "cpgimp", ""},
                                    {"integrator", "cd", ""},
                                    {"boundary", "symmetry", ""},
                                    {"cells", std::to_string(cells), ""},
                                    {"ppc", std::to_string(per_cell), ""},
                                    {"cfl", "0.4", ""},
                                    {"end_time", "0.005", ""}});
    motion.step_to(motion.resolution().steps);
    const Tiling tiling = tiling_of(voxels_of(motion.mpm(), cells));
    const double spacing = 1.0 / (cells * per_cell);
    const std::string on = "_" + std::to_string(cells), where = " on " + std::to_string(cells) + "³ cells";
    result.add("volume_error" + on, tiling.volume_error, "volume of all voxels against the body's" + where);
    result.add("gap" + on, tiling.gap / spacing,
               "largest gap or overlap of neighbours, in undeformed voxel widths" + where);
    result.add("exact_gap" + on, tiling_of(exact_voxels_of(motion, cells)).gap / spacing,
               "the same of the exact solution's voxels" + where);
    result.add("offset" + on, tiling.offset / spacing,
               "largest offset of neighbours across their axis, in undeformed voxel widths" + where);
    if (cells != 8) {
      result.add("gap_ratio", coarse_gap / tiling.gap / 2, "gap on 8³ over that on 16³ cells, each in its voxels");
      continue;
    }
    coarse_gap = tiling.gap;
    const auto n = static_cast<std::uint32_t>(cells * per_cell);
    result.series.push_back(
        profiles::particle_panel("t = 0.005 s", motion.mpm(), [n](std::uint32_t id) { return id / (n * n) == n / 2; }));
  }
  return result;
}

}  // namespace mpmvv::checks
