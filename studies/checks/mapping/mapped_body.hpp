#pragma once
#include <array>
#include <string>

#include "studies/checks/mapping/domain_quadrature.hpp"
#include "studies/checks/mapping/matrix_product.hpp"
#include "studies/checks/mapping/particle_basis.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::checks::mapping {

using support::to_string;

/// How a mapping weighs nodal functions over a particle: by their values N_j(x_p) (a Dirac formulation), or by their
/// averages over its box, B (16.16).
struct Weighting {
  const char* name;
  GridBasis field;     ///< the basis of the field, N_i(x) of B (16.1)
  GridBasis particle;  ///< the basis that gives the weights v_ip
};

inline const Weighting dirac{"dirac", solver::Linear{}, solver::Linear{}};
inline const Weighting spline{"spline", solver::BSpline2{}, solver::BSpline2{}};
inline const Weighting gimp{"gimp", solver::Linear{}, solver::Gimp{}};

/// The mass matrix on the left of the mapping. B has three consistent matrices, which differ:
///   lumped      Σ_p M_p v_ip on the diagonal, B (16.22)
///   exact       ∫ N_i N_j ρ dV with the material's density, B (16.7)
///   piecewise   the same with ρ = M_p/V_p on each box, B (16.19) and (16.20) under the assumption of (16.15)
///   quadrature  Σ_p M_p v_ip v_jp, by the points of B (16.14); the mass matrix of MPM codes, SᵀMS in N §2.1
enum class MassKind { lumped, exact, piecewise, quadrature };

inline constexpr std::array mass_kinds{MassKind::lumped, MassKind::exact, MassKind::piecewise, MassKind::quadrature};

constexpr std::array<const char*, 4> words_of(MassKind) {
  return {"lumped", "exact", "piecewise", "quadrature"};
}

enum class WeightedBy { mass, volume };

/// Particles on a grid, mapped with a weighting by mass or by volume. With `volume` the volumes take the place of the
/// masses M_p, and the density is 1.
template <int D>
class MappedBody {
 public:
  MappedBody(const OverlayGrid<D>& grid, const ParticleTiling<D>& tiling, const Weighting& weighting,
             WeightedBy weighted_by = WeightedBy::mass)
      : grid_(grid),
        tiling_(tiling),
        weighting_(weighting),
        weighted_by_(weighted_by),
        field_(weighting.field, grid),
        M_(weighted_by == WeightedBy::mass ? tiling.masses() : tiling.volumes()),
        v_(NodalBasis<D>(weighting.particle, grid).weights(tiling.x, tiling.width)) {}

  /// Returns the same mapping of the moved particles `tiling` on `grid`, which may have moved too.
  MappedBody moved(const OverlayGrid<D>& grid, const ParticleTiling<D>& tiling) const {
    return MappedBody(grid, tiling, weighting_, weighted_by_);
  }

  const OverlayGrid<D>& grid() const { return grid_; }
  const ParticleTiling<D>& tiling() const { return tiling_; }
  const Weighting& weighting() const { return weighting_; }
  const NodalBasis<D>& field() const { return field_; }
  const Eigen::VectorXd& M() const { return M_; }
  const Eigen::MatrixXd& v() const { return v_; }

  Eigen::MatrixXd mass_matrix(MassKind kind) const;
  ParticleBasis basis(MassKind kind) const {
    return kind == MassKind::lumped ? ParticleBasis::lumped(v_, M_)
                                    : ParticleBasis::consistent(mass_matrix(kind), v_, M_);
  }

  /// Returns the weights ρ dV of the quadrature's points. ρ is the material's density if `density` is `exact` and the
  /// mapping is by mass, and M_p/V_p otherwise.
  Eigen::VectorXd weights_of(const DomainQuadrature<D>& points, MassKind density) const;

 private:
  OverlayGrid<D> grid_;
  ParticleTiling<D> tiling_;
  Weighting weighting_;
  WeightedBy weighted_by_;
  NodalBasis<D> field_;
  Eigen::VectorXd M_;
  Eigen::MatrixXd v_;
};

template <int D>
Eigen::MatrixXd MappedBody<D>::mass_matrix(MassKind kind) const {
  if (kind == MassKind::lumped) return Eigen::VectorXd(v_ * M_).asDiagonal();
  if (kind == MassKind::quadrature) return matrix_product(v_ * M_.asDiagonal(), v_.transpose());
  const DomainQuadrature<D> points(tiling_, grid_);
  const auto N = field_.weights(points.x);
  const Eigen::SparseMatrix<double> weighted = N * weights_of(points, kind).asDiagonal();
  return Eigen::SparseMatrix<double>(weighted * N.transpose());
}

template <int D>
Eigen::VectorXd MappedBody<D>::weights_of(const DomainQuadrature<D>& points, MassKind density) const {
  const Eigen::VectorXd V = tiling_.volumes();
  Eigen::VectorXd weights(static_cast<Eigen::Index>(points.x.size()));
  for (std::size_t q = 0; q < points.x.size(); ++q) {
    const Eigen::Index p = points.particle[q];
    const bool varies = density == MassKind::exact && weighted_by_ == WeightedBy::mass;
    weights[static_cast<Eigen::Index>(q)] = points.dV[q] * (varies ? tiling_.density(points.x[q]) : M_[p] / V[p]);
  }
  return weights;
}

}  // namespace mpmvv::checks::mapping
