#pragma once
#include <Eigen/LU>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>

#include "mms/radii.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A piece of a body: reference points X over the unit box, and ∂X/∂ξ.
template <int D>
struct Place {
  Vec<D> X;
  Mat<D> gradient;
};
template <int D>
using Piece = std::function<Place<D>(const Vec<D>& xi)>;

template <int D>
Piece<D> box(const Vec<D>& lower, const Vec<D>& size) {
  return [=](const Vec<D>& xi) { return Place<D>{lower + size.cwiseProduct(xi), size.asDiagonal()}; };
}

/// Between the radii, part of the way round; cut so that no symmetry makes its forces cancel.
template <int D>
Piece<D> sector(const Radii& radii);

template <>
inline Piece<2> sector(const Radii& radii) {
  return [=](const Vec<2>& xi) {
    const double width = radii.outer - radii.inner, R = radii.inner + width * xi[0], theta = 0.2 + 1.5 * xi[1];
    const Vec<2> e_R(std::cos(theta), std::sin(theta)), e_theta(-e_R[1], e_R[0]);
    Place<2> place{R * e_R, {}};
    place.gradient << width * e_R, 1.5 * R * e_theta;
    return place;
  };
}

template <>
inline Piece<3> sector(const Radii& radii) {
  return [=](const Vec<3>& xi) {
    const double width = radii.outer - radii.inner, R = radii.inner + width * xi[0];
    const double theta = 0.3 + 1.1 * xi[1], phi = 0.2 + 1.5 * xi[2];  // from the pole, and around it
    const Vec<3> e_R(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    const Vec<3> e_theta(std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), -std::sin(theta));
    const Vec<3> e_phi(-std::sin(phi), std::cos(phi), 0);
    Place<3> place{R * e_R, {}};
    place.gradient << width * e_R, 1.1 * R * e_theta, 1.5 * R * std::sin(theta) * e_phi;
    return place;
  };
}

/// Calls f(ξ, weight) at the Gauss points of the unit box; of its face ξ_fixed = const where `fixed` names an axis.
template <int D, class F>
void at_gauss_points(Vec<D> xi, int fixed, const F& f, int axis = 0, double weight = 1) {
  if (axis == D) return f(xi, weight);
  if (axis == fixed) return at_gauss_points(xi, fixed, f, axis + 1, weight);
  using Rule = boost::math::quadrature::gauss<double, 20>;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double sign : {-1, 1}) {
      xi[axis] = (1 + sign * Rule::abscissa()[k]) / 2;
      at_gauss_points(xi, fixed, f, axis + 1, weight * Rule::weights()[k] / 2);
    }
}

/// |∫ρ₀ (b - a) dV + ∮ P N dA| of a piece, over the sum of the magnitudes.
template <int D>
double imbalance(const ManufacturedSolution<D>& solution, double density, const Piece<D>& piece, double t) {
  Vec<D> force = Vec<D>::Zero();
  double magnitude = 0;
  const auto add = [&](const Vec<D>& f, double weight) {
    force += weight * f;
    magnitude += weight * f.norm();
  };
  at_gauss_points<D>(Vec<D>::Zero(), -1, [&](const Vec<D>& xi, double weight) {
    const auto [X, gradient] = piece(xi);
    const double dV = weight * std::abs(gradient.determinant());
    add(density * solution.b(X, t), dV);
    add(-density * solution.a(X, t), dV);
  });
  for (int axis = 0; axis < D; ++axis)
    for (const int side : {0, 1})
      at_gauss_points<D>(side * Vec<D>::Unit(axis), axis, [&](const Vec<D>& xi, double weight) {
        const auto [X, gradient] = piece(xi);
        const Vec<D> outward = (2 * side - 1) * gradient.inverse().transpose().col(axis);
        const double dA = weight * std::abs(gradient.determinant()) * outward.norm();
        add(solution.traction(X, outward.normalized(), t), dA);
      });
  return force.norm() / magnitude;
}

}  // namespace mpmvv::mms
