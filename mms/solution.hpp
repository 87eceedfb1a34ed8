#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mms/expression/formulas.hpp"

namespace mpmvv::mms {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

template <int D>
using Mat = Eigen::Matrix<double, D, D>;

/// A solution evaluated at fixed reference points, which computes once what many of them share. `ids` are indices into
/// the list of points given to `ManufacturedSolution::at_points`. Several threads may call the const members at once.
template <int D>
class PointwiseSolution {
 public:
  virtual ~PointwiseSolution() = default;

  /// Computes once what all points share at time t, for calls of `body_force` at that time. No such call may run during
  /// this one. At a time for which it was not called, `body_force` gives the same numbers but takes longer.
  virtual void prepare(double) {}
  virtual void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const = 0;

  /// Writes b of the points with these ids to `b`. X has the reference position of each of them; it may be empty where
  /// `reads_places` is false.
  virtual void body_force(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>> X, Vec<D>* b) const = 0;
  /// Whether `body_force` reads X. It then need not look up points by id, at scattered places in memory.
  virtual bool reads_places() const = 0;
};

/// An exact solution of Div P + ρ₀ b = ρ₀ a, W (52), in reference coordinates X and time t. SI units.
/// P is the first Piola-Kirchhoff stress, P_iJ, with Div P = ∂P_iJ/∂X_J.
template <int D>
class ManufacturedSolution {
 public:
  virtual ~ManufacturedSolution() = default;

  virtual Vec<D> u(const Vec<D>& X, double t) const = 0;  ///< displacement
  virtual Vec<D> v(const Vec<D>& X, double t) const = 0;  ///< velocity
  virtual Vec<D> a(const Vec<D>& X, double t) const = 0;  ///< acceleration
  virtual Mat<D> F(const Vec<D>& X, double t) const = 0;  ///< deformation gradient, I + ∂u/∂X
  virtual Mat<D> P(const Vec<D>& X, double t) const = 0;  ///< first Piola-Kirchhoff stress
  virtual Vec<D> b(const Vec<D>& X, double t) const = 0;  ///< body force per mass

  /// Returns P N, the force per reference area on a surface with the reference unit normal N.
  Vec<D> traction(const Vec<D>& X, const Vec<D>& N, double t) const { return P(X, t) * N; }

  virtual double displacement_scale() const = 0;  ///< the largest |u|, up to a factor of order one

  /// Returns this solution at many fixed points; this solution must outlive what is returned. Solutions override it
  /// that compute once what points share, or evaluate points in lanes.
  virtual std::unique_ptr<PointwiseSolution<D>> at_points(const std::vector<Vec<D>>& X) const;

  /// Returns the fields as expressions; empty where there is no closed form.
  virtual expression::Formulas formulas() const { return {}; }

  /// Returns the X with X + u(X, t) = x, W (A.1). This default uses Newton's method and throws std::domain_error when
  /// it does not converge.
  virtual Vec<D> reference_point(const Vec<D>& x, double t) const;
};

extern template class ManufacturedSolution<1>;
extern template class ManufacturedSolution<2>;
extern template class ManufacturedSolution<3>;

}  // namespace mpmvv::mms
