#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <cmath>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/cases.hpp"

namespace mpmvv::checks::mapping {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// A weighted sum of squares E(F) = Σ_k w_k (Σ_i N_ik F_i - f_k)², and its least value. The iteration that finds the
/// least value uses no mass matrix.
class Residual {
 public:
  Residual(const Sparse& N, const Eigen::VectorXd& weights, const Eigen::VectorXd& f)
      : A_(weights.cwiseSqrt().asDiagonal() * Sparse(N.transpose())), b_(weights.cwiseSqrt().cwiseProduct(f)) {
    Eigen::LeastSquaresConjugateGradient<Sparse> least_squares(A_);
    least_squares.setTolerance(1e-12);
    least_ = (*this)(Eigen::VectorXd(least_squares.solve(b_)));
  }

  double operator()(const Eigen::VectorXd& F) const { return (A_ * F - b_).squaredNorm(); }
  double excess(const Eigen::VectorXd& F) const { return (*this)(F) / least_ - 1; }

 private:
  Sparse A_;
  Eigen::VectorXd b_;
  double least_ = 0;
};

/// Returns the value at x of the field that is mapped. The field is smooth, with a wave length of some five cells.
template <int D>
double field_at(const solver::Vec<D>& x) {
  double f = 1;
  for (int d = 0; d < D; ++d) f *= std::sin(1.2 * x[d] + 0.4 + d) + 0.3 * x[d];
  return f;
}

template <int D>
Eigen::VectorXd values_at(const Points<D>& x) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) f[static_cast<Eigen::Index>(k)] = field_at<D>(x[k]);
  return f;
}

/// A body whose particles take their data from the field, f_p = f(x_p), and the three residuals that its mapping may be
/// asked to minimise:
///   field  ∫ (F - f)² ρ dV with the field and the density themselves, B (16.2)
///   data   the same with f_p and M_p/V_p on each box: all that the particles know
///   sum    Σ_p M_p (Σ_i v_ip F_i - f_p)², the integral by the particles' own quadrature
template <int D>
class MappedField {
 public:
  explicit MappedField(const MappedBody<D>& body)
      : body_(body),
        points_(body.tiling(), body.grid()),
        N_(body.field().weights(points_.x)),
        f_(values_at<D>(points_.x)),
        f_p_(values_at<D>(body.tiling().x)),
        residuals_{Residual(N_, body.weights_of(points_, MassKind::exact), f_),
                   Residual(N_, body.weights_of(points_, MassKind::piecewise), f_p_(points_.particle)),
                   Residual(body.v().sparseView(), body.M(), f_p_)} {}

  /// Returns the relative excess over the least residual `field` when the field itself is mapped, with both sides of
  /// the mapping integrated, B (16.6) to (16.8).
  double excess_of_integrals() const {
    const Eigen::VectorXd weights = body_.weights_of(points_, MassKind::exact);
    return residuals_[0].excess(nodal_values(body_.mass_matrix(MassKind::exact), N_, weights, f_));
  }

  /// Returns the relative excess over the least value of each residual when the particles' data are mapped, B (16.17)
  /// or (16.23).
  std::array<double, 3> excesses(MassKind mass) const {
    const Eigen::VectorXd F = body_.basis(mass).psi() * f_p_;
    return {residuals_[0].excess(F), residuals_[1].excess(F), residuals_[2].excess(F)};
  }

 private:
  const MappedBody<D>& body_;
  DomainQuadrature<D> points_;
  Sparse N_;
  Eigen::VectorXd f_, f_p_;
  std::array<Residual, 3> residuals_;
};

constexpr std::array residual_names{"field", "data", "sum"};

/// The largest excesses over all bodies with one weighting; for the lumped mass the least.
struct Excesses {
  double integrals = 0;
  std::array<std::array<double, 3>, mass_kinds.size()> of{};

  Excesses(const Weighting& weighting, WeightedBy weighted_by) {
    of[0].fill(std::numeric_limits<double>::infinity());
    add_blocks<1>(weighting, weighted_by);
    add_blocks<2>(weighting, weighted_by);
  }

 private:
  template <int D>
  void add_blocks(const Weighting& weighting, WeightedBy weighted_by) {
    for (const Placement placement : placements) {
      const MappedBody<D> body(BlockOfParticles<D>::grid(), BlockOfParticles<D>::tiling(placement), weighting,
                               weighted_by);
      const MappedField<D> field(body);
      keep_larger(integrals, field.excess_of_integrals());
      for (std::size_t k = 0; k < mass_kinds.size(); ++k) {
        const auto now = field.excesses(mass_kinds[k]);
        for (std::size_t r = 0; r < now.size(); ++r)
          (mass_kinds[k] == MassKind::lumped ? keep_smaller : keep_larger)(of[k][r], now[r]);
      }
    }
  }
};

void add_residuals(CheckResult& result, WeightedBy weighted_by, const std::string& prefix) {
  double integrals = 0;
  for (const Weighting& weighting : weightings) {
    const Excesses excesses(weighting, weighted_by);
    keep_larger(integrals, excesses.integrals);
    for (std::size_t r = 0; r < residual_names.size(); ++r)
      for (std::size_t k = 0; k < mass_kinds.size(); ++k) {
        const std::string mass = to_string(mass_kinds[k]);
        result.add(fmt::format("{}{}_{}_{}", prefix, residual_names[r], mass, weighting.name), excesses.of[k][r],
                   fmt::format("{} mass, {} weights: {} excess over the least residual '{}'", mass, weighting.name,
                               k == 0 ? "least" : "largest", residual_names[r]));
      }
  }
  result.add(prefix + "integrals", integrals, "both sides integrated: largest excess over the least residual 'field'");
}

}  // namespace

}  // namespace mpmvv::checks::mapping

namespace mpmvv::checks {

/// Measures claim B-lsq, and the part of claim B-vol that is about residuals.
CheckResult check_mapping_residuals() {
  CheckResult result;
  mapping::add_residuals(result, mapping::WeightedBy::mass, "");
  mapping::add_residuals(result, mapping::WeightedBy::volume, "volume_");
  return result;
}

}  // namespace mpmvv::checks
