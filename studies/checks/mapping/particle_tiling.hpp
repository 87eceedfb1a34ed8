#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "studies/checks/mapping/nodal_basis.hpp"

namespace mpmvv::checks::mapping {

/// Particles at the centres of boxes Ω_p, their physical domains, which fill a block without gaps or overlaps. The
/// density is linear in space, so the mass of a box is its volume times the density at its centre.
template <int D>
struct ParticleTiling {
  using Vec = solver::Vec<D>;

  Points<D> x, width;
  Vec lower, upper;             ///< opposite corners of the block
  double density_at_lower = 1;  ///< density of the material at `lower`
  Vec density_gradient = Vec::Zero();

  Eigen::Index size() const { return static_cast<Eigen::Index>(x.size()); }
  double density(const Vec& at) const { return density_at_lower + density_gradient.dot(at - lower); }
  Eigen::VectorXd volumes() const;
  Eigen::VectorXd masses() const;
  bool boxes_are_alike() const;

  /// Whether a point lies in the block, at least `depth` from its faces; a point on a face counts as inside.
  bool contains(const Vec& at, const Vec& depth = Vec::Zero()) const;
  bool box_is_inside(std::size_t p, const Vec& depth) const;

  ParticleTiling translated(const Vec& u) const;
  ParticleTiling stretched(const Vec& factor, const Vec& about = Vec::Zero()) const;  ///< keeps the masses
};

/// Returns `count` equal boxes along each axis, of unit density.
template <int D>
ParticleTiling<D> uniform_tiling(const solver::Vec<D>& lower, const solver::Vec<D>& extent,
                                 const solver::Index<D>& count);

/// Returns as many boxes in rows of random heights, each row divided at random. The heights differ by a factor of three
/// at most, and so do the widths within a row. Along each axis the density grows by twice its value at `lower`.
template <int D>
ParticleTiling<D> random_tiling(const solver::Vec<D>& lower, const solver::Vec<D>& extent,
                                const solver::Index<D>& count, std::uint64_t seed);

ParticleTiling<1> tiling_of_widths(double lower, const std::vector<double>& widths);

}  // namespace mpmvv::checks::mapping
