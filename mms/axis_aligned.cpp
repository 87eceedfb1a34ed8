#include "mms/axis_aligned.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace mpmvv::mms {

using std::numbers::pi;

template <int D>
AxisAligned<D>::AxisAligned(double amplitude, int wave_number, const std::array<Course, D>& courses,
                            const Elasticity& material)
    : A_(amplitude),
      k_pi_(wave_number * pi),
      lambda_(material.lambda()),
      mu_(material.mu()),
      rho_(material.density),
      C_pi_(std::sqrt(material.youngs_modulus / material.density) * pi) {
  for (std::size_t d = 0; d < D; ++d) {
    const auto axis = static_cast<int>(d);
    phases_[axis] = courses[d].phase, rests_[axis] = courses[d].rest, swings_[axis] = courses[d].swing;
  }
}

template <int D>
Vec<D> AxisAligned<D>::T(double t) const {
  return rests_.array() + swings_.array() * (C_pi_ * t + phases_.array()).sin();
}

template <int D>
Vec<D> AxisAligned<D>::stretches(const Vec<D>& X, double t) const {
  return 1 + k_pi_ * A_ * (k_pi_ * X).array().cos() * T(t).array();
}

template <int D>
template <class N>
N AxisAligned<D>::u_along(std::size_t d, const N& X, const N& t) const {
  using std::sin;
  return A_ * sin(k_pi_ * X) * (rests_.data()[d] + swings_.data()[d] * sin(C_pi_ * t + phases_.data()[d]));
}

template <int D>
template <class N>
N AxisAligned<D>::b_along(const N& a, const N& u, const N& F, const N& K) const {
  const N stiffness = lambda_ * (1 - K) / (F * F) + mu_ * (1 + 1 / (F * F));
  return a + k_pi_ * k_pi_ * u * stiffness / rho_;
}

template <int D>
Vec<D> AxisAligned<D>::u(const Vec<D>& X, double t) const {
  return A_ * (k_pi_ * X).array().sin() * T(t).array();
}

template <int D>
Vec<D> AxisAligned<D>::v(const Vec<D>& X, double t) const {
  return A_ * C_pi_ * (k_pi_ * X).array().sin() * swings_.array() * (C_pi_ * t + phases_.array()).cos();
}

template <int D>
Vec<D> AxisAligned<D>::a(const Vec<D>& X, double t) const {
  return -C_pi_ * C_pi_ * A_ * (k_pi_ * X).array().sin() * (T(t) - rests_).array();
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
  const Vec<D> a = this->a(X, t), u = this->u(X, t);
  Vec<D> b;
  for (int d = 0; d < D; ++d) b[d] = b_along(a[d], u[d], F[d], K);
  return b;
}

template <int D>
expression::Formulas AxisAligned<D>::formulas() const {
  const auto X = expression::reference_place<D>();
  expression::Vector u;
  for (std::size_t d = 0; d < D; ++d) u.push_back(u_along(d, X[d], expression::time()));
  expression::Fields fields = expression::motion(u, {});
  expression::Traced J = 1;
  for (std::size_t d = 0; d < D; ++d) J *= fields.F[d][d];
  for (std::size_t d = 0; d < D; ++d) {
    const auto a = derivative(fields.v[d], expression::Variable::t);
    fields.b.push_back(b_along(a, u[d], fields.F[d][d], log(J)));
  }
  return {.reference = fields};
}

/// On a lattice many points share a coordinate. For each axis, tables hold what depends on one coordinate, with an
/// entry for each distinct value: sin and cos, and the parts of b for the time last prepared. A point has only its
/// places in these tables.
template <int D>
class AxisAligned<D>::AtPoints final : public PointwiseSolution<D> {
 public:
  AtPoints(AxisAligned solution, const std::vector<Vec<D>>& X) : solution_(std::move(solution)), places_(X.size()) {
    for (std::size_t d = 0; d < D; ++d) {
      std::unordered_map<double, std::uint32_t> known;
      for (std::size_t p = 0; p < X.size(); ++p) {
        const double X_d = X[p][static_cast<int>(d)];
        const auto [entry, is_new] = known.try_emplace(X_d, static_cast<std::uint32_t>(known.size()));
        if (is_new) waves_[d].push_back({std::sin(solution_.k_pi_ * X_d), std::cos(solution_.k_pi_ * X_d)});
        places_[p][d] = entry->second;
      }
    }
  }

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const override {
    const Vec<D> A_T = solution_.A_ * solution_.T(t);
    for (const auto id : ids) {
      for (std::size_t d = 0; d < D; ++d) u->data()[d] = A_T.data()[d] * waves_[d][places_[id][d]].sin;
      ++u;
    }
  }

  void prepare(double t) override {
    if (parts_.t != t) set(parts_, t);
  }

  void body_force(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    Parts own;
    const Parts& parts = parts_.t == t ? parts_ : set(own, t);
    const double lambda_and_mu = solution_.lambda_ + solution_.mu_;
    for (const auto id : ids) {
      const auto& places = places_[id];
      Eigen::Vector4d sum = parts.of_axis[0][places[0]].constant_and_log, factor = parts.of_axis[0][places[0]].factor;
      for (std::size_t d = 1; d < D; ++d) {
        const Part& part = parts.of_axis[d][places[d]];
        sum += part.constant_and_log, factor += part.factor;
      }
      sum += factor * (lambda_and_mu - sum[3]);
      for (int d = 0; d < D; ++d) b->data()[d] = sum[d];
      ++b;
    }
  }
  bool reads_places() const override { return false; }

 private:
  struct Wave {
    double sin, cos;
  };

  /// What an axis adds to b = constant + factor (λ + μ - Σ λ ln F_d), in registers that hold all components: functions
  /// of its coordinate in its own component, and its logarithm in the last one.
  struct Part {
    Eigen::Vector4d constant_and_log;  ///< a_d + π² u_d k² μ / ρ₀, and λ ln F_d
    Eigen::Vector4d factor;            ///< π² u_d k² F_d⁻² / ρ₀
  };
  struct Parts {
    double t = std::numeric_limits<double>::quiet_NaN();
    std::array<std::vector<Part>, D> of_axis;
  };

  const Parts& set(Parts& parts, double t) const {
    const AxisAligned& s = solution_;
    const Vec<D> A_T = s.A_ * s.T(t), A_T_tt = -s.C_pi_ * s.C_pi_ * (A_T - s.A_ * s.rests_);
    const double k2 = s.k_pi_ * s.k_pi_;
    parts.t = t;
    for (std::size_t d = 0; d < D; ++d) {
      parts.of_axis[d].clear();
      for (const Wave& wave : waves_[d]) {
        const double u = A_T.data()[d] * wave.sin, F = 1 + s.k_pi_ * A_T.data()[d] * wave.cos;
        const Eigen::Vector4d own = Eigen::Vector4d::Unit(static_cast<int>(d));
        const double a = A_T_tt.data()[d] * wave.sin;
        Part part{(a + u * k2 * s.mu_ / s.rho_) * own, u * k2 / (F * F) / s.rho_ * own};
        if (s.lambda_ != 0) part.constant_and_log[3] = s.lambda_ * std::log(F);
        parts.of_axis[d].push_back(part);
      }
    }
    return parts;
  }

  const AxisAligned solution_;
  std::array<std::vector<Wave>, D> waves_;
  std::vector<std::array<std::uint32_t, D>> places_;
  Parts parts_;
};

template <int D>
std::unique_ptr<PointwiseSolution<D>> AxisAligned<D>::at_points(const std::vector<Vec<D>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

template class AxisAligned<1>;
template class AxisAligned<2>;
template class AxisAligned<3>;

}  // namespace mpmvv::mms
