#include "mms/axis_aligned.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace mpmvv::mms {

using std::numbers::pi;

template <int D>
AxisAligned<D>::AxisAligned(double amplitude, int wave_number, const Vec<D>& phases, const Elasticity& material)
    : A_(amplitude),
      k_pi_(wave_number * pi),
      E_(material.youngs_modulus),
      lambda_(material.lambda()),
      mu_(material.mu()),
      rho_(material.density),
      C_pi_(std::sqrt(E_ / rho_) * pi),
      phases_(phases) {}

template <int D>
Vec<D> AxisAligned<D>::T(double t) const {
  return (C_pi_ * t + phases_.array()).sin();
}

template <int D>
Vec<D> AxisAligned<D>::stretches(const Vec<D>& X, double t) const {
  return 1 + k_pi_ * A_ * (k_pi_ * X).array().cos() * T(t).array();
}

template <int D>
Vec<D> AxisAligned<D>::u(const Vec<D>& X, double t) const {
  return A_ * (k_pi_ * X).array().sin() * T(t).array();
}

template <int D>
Vec<D> AxisAligned<D>::v(const Vec<D>& X, double t) const {
  return A_ * C_pi_ * (k_pi_ * X).array().sin() * (C_pi_ * t + phases_.array()).cos();
}

template <int D>
Vec<D> AxisAligned<D>::a(const Vec<D>& X, double t) const {
  return -C_pi_ * C_pi_ * u(X, t);
}

template <int D>
Mat<D> AxisAligned<D>::F(const Vec<D>& X, double t) const {
  return stretches(X, t).asDiagonal();
}

template <int D>
Mat<D> AxisAligned<D>::P(const Vec<D>& X, double t) const {
  const auto F = stretches(X, t).array().eval();
  const double K = std::log(F.prod());
  return Vec<D>((lambda_ * K + mu_ * (F * F - 1)) / F).asDiagonal();
}

template <int D>
Vec<D> AxisAligned<D>::b(const Vec<D>& X, double t) const {
  const auto F = stretches(X, t).array().eval();
  const double K = std::log(F.prod());
  const auto bracket = k_pi_ * k_pi_ * (lambda_ * (1 - K) / (F * F) + mu_ * (1 + 1 / (F * F))) - pi * pi * E_;
  return u(X, t).array() * bracket / rho_;
}

/// sin kπX_d and cos kπX_d of every distinct coordinate, and for each point its place in these tables.
template <int D>
class AxisAligned<D>::AtPoints final : public PointwiseSolution<D> {
 public:
  AtPoints(const AxisAligned& solution, const std::vector<Vec<D>>& X) : solution_(solution), places_(X.size()) {
    for (std::size_t d = 0; d < D; ++d) {
      std::unordered_map<double, std::uint32_t> known;
      for (std::size_t p = 0; p < X.size(); ++p) {
        const double X_d = X[p][static_cast<int>(d)];
        const auto [entry, is_new] = known.try_emplace(X_d, static_cast<std::uint32_t>(known.size()));
        if (is_new) table_[d].push_back({std::sin(solution_.k_pi_ * X_d), std::cos(solution_.k_pi_ * X_d)});
        places_[p][d] = entry->second;
      }
    }
  }

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const override {
    const Vec<D> A_T = solution_.A_ * solution_.T(t);
    for (const auto id : ids) {
      for (int d = 0; d < D; ++d) (*u)[d] = A_T[d] * harmonic(id, d).sin;
      ++u;
    }
  }

  void body_force(double t, std::span<const std::uint32_t> ids, Vec<D>* b) const override {
    const Vec<D> A_T = solution_.A_ * solution_.T(t);
    for (; !ids.empty(); ids = ids.subspan(std::min<std::size_t>(ids.size(), lanes)), b += lanes)
      few_body_forces(A_T, ids.first(std::min<std::size_t>(ids.size(), lanes)), b);
  }

 private:
  static constexpr int lanes = 32;  ///< points at a time, so that divisions and logarithms run side by side
  using Lanes = Eigen::Array<double, lanes, 1>;
  struct Harmonic {
    double sin, cos;
  };

  const Harmonic& harmonic(std::uint32_t id, int axis) const {
    const auto d = static_cast<std::size_t>(axis);
    return table_[d][places_[id][d]];
  }

  void few_body_forces(const Vec<D>& A_T, std::span<const std::uint32_t> ids, Vec<D>* b) const {
    const int n = static_cast<int>(ids.size());
    Lanes u[D], F[D], J = Lanes::Ones();
    for (int d = 0; d < D; ++d) {
      u[d].setZero(), F[d].setOnes();
      for (int k = 0; k < n; ++k) {
        const Harmonic& at = harmonic(ids[static_cast<std::size_t>(k)], d);
        u[d][k] = A_T[d] * at.sin;
        F[d][k] = 1 + solution_.k_pi_ * A_T[d] * at.cos;
      }
      J *= F[d];
    }
    Lanes numerator = Lanes::Constant(solution_.lambda_ + solution_.mu_);  // λ (1 - K) + μ
    if (solution_.lambda_ != 0) numerator -= solution_.lambda_ * J.log();
    const double k2 = solution_.k_pi_ * solution_.k_pi_;
    for (int d = 0; d < D; ++d) {
      const Lanes b_d =
          u[d] * (k2 * (numerator / (F[d] * F[d]) + solution_.mu_) - pi * pi * solution_.E_) / solution_.rho_;
      for (int k = 0; k < n; ++k) b[k][d] = b_d[k];
    }
  }

  const AxisAligned solution_;
  std::array<std::vector<Harmonic>, D> table_;
  std::vector<std::array<std::uint32_t, D>> places_;
};

template <int D>
std::unique_ptr<PointwiseSolution<D>> AxisAligned<D>::at_points(const std::vector<Vec<D>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

template class AxisAligned<2>;
template class AxisAligned<3>;

}  // namespace mpmvv::mms
