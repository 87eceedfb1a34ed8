#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::textbook_test {

/// The step once more, written down plainly: every particle with every node of a periodic unit box of
/// quadratic B-splines, no stencils, ghosts, slabs or sorting. S (1) to (10), W (8) to (19), (51), N §2.3.
template <int D>
class Textbook {
 public:
  Textbook(const Scene<D>& scene) : h_(scene.h), n_(scene.cells[0]), s_(scene.particles) {
    const auto& material = std::get<NeoHookeanLog>(scene.material);
    lambda_ = material.lambda, mu_ = material.mu;
    for (int k = 0; k < std::pow(n_, D) - 0.5; ++k) {
      Vec<D> x;
      for (int d = 0, rest = k; d < D; ++d, rest /= n_) x[d] = h_ * (rest % n_);
      nodes_.push_back(x);
    }
  }

  void usl(double dt) {
    evaluate();
    const auto v = mapped_velocity();
    const auto a = acceleration();
    auto v_new = v;
    for (std::size_t i = 0; i < v.size(); ++i) v_new[i] += dt * a[i];
    const auto F = deformed(v_new, dt);
    move(v_new, a, dt);
    s_.F = F;
  }

  void usf(double dt) {
    evaluate();
    auto v = mapped_velocity();
    s_.F = deformed(v, dt);
    const auto a = acceleration();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * a[i];
    move(v, a, dt);
  }

  void uvf(double dt) {
    evaluate();
    const auto a = acceleration();
    for (std::size_t p = 0; p < s_.size(); ++p)
      for (std::size_t i = 0; i < nodes_.size(); ++i) s_.v[p] += dt * weight_[p][i] * a[i];
    const auto v = mapped_velocity();
    s_.F = deformed(v, dt);
    move(v, Array<Vec<D>>(v.size(), Vec<D>::Zero()), dt);
  }

  void usavg(double dt) {
    evaluate();
    auto v = mapped_velocity();
    s_.F = deformed(v, dt / 2);
    const auto a = acceleration();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * a[i];
    s_.F = deformed(v, dt / 2);
    move(v, a, dt);
  }

  void usl_plus(double dt) {
    evaluate();
    auto v = mapped_velocity();
    const auto a = acceleration();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * a[i];
    move(v, a, dt);
    s_.F = deformed(mapped_velocity(), dt);
  }

  void usavg_plus(double dt) {
    evaluate();
    auto v = mapped_velocity();
    s_.F = deformed(v, dt / 2);
    const auto a = acceleration();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += dt * a[i];
    move(v, a, dt);
    s_.F = deformed(mapped_velocity(), dt / 2);
  }

  void rk4(double dt) {
    const Particles<D> start = s_;
    const auto k1 = rates();
    s_ = moved(start, k1, dt / 2);
    const auto k2 = rates();
    s_ = moved(start, k2, dt / 2);
    const auto k3 = rates();
    s_ = moved(start, k3, dt);
    const auto k4 = rates();
    s_ = moved(moved(moved(moved(start, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
  }

  const Particles<D>& particles() const { return s_; }

 private:
  /// x', v' and F' of every particle, in the fields x, v and F.
  Particles<D> rates() {
    evaluate();
    const auto v = mapped_velocity();
    const auto a = acceleration();
    const Particles<D> here = s_;
    Particles<D> rates = s_;
    for (auto* field : {&s_.x, &s_.v}) field->assign(field->size(), Vec<D>::Zero());
    move(v, a, 1);
    rates.x = s_.x, rates.v = s_.v;
    s_ = here;
    rates.F = deformed(v, 1);
    for (std::size_t p = 0; p < s_.size(); ++p) rates.F[p] -= s_.F[p];
    return rates;
  }

  static Particles<D> moved(Particles<D> from, const Particles<D>& rates, double dt) {
    for (std::size_t p = 0; p < from.size(); ++p) {
      from.x[p] += dt * rates.x[p];
      from.v[p] += dt * rates.v[p];
      from.F[p] += dt * rates.F[p];
    }
    return from;
  }

  static double spline(double r) {
    r = std::abs(r);
    return r < 0.5 ? 0.75 - r * r : r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0;
  }
  static double slope(double r) {
    const double size = std::abs(r);
    return size < 0.5 ? -2 * r : size < 1.5 ? (size - 1.5) * (r < 0 ? -1 : 1) : 0;
  }

  void evaluate() {
    weight_.assign(s_.size(), std::vector<double>(nodes_.size(), 1));
    gradient_.assign(s_.size(), Array<Vec<D>>(nodes_.size(), Vec<D>::Ones()));
    for (std::size_t p = 0; p < s_.size(); ++p)
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (int d = 0; d < D; ++d) {
          double r = (s_.x[p][d] - nodes_[i][d]) / h_;
          r -= n_ * std::round(r / n_);
          weight_[p][i] *= spline(r);
          for (int e = 0; e < D; ++e) gradient_[p][i][e] *= e == d ? slope(r) / h_ : spline(r);
        }
    mass_.assign(nodes_.size(), 0);
    for (std::size_t p = 0; p < s_.size(); ++p)
      for (std::size_t i = 0; i < nodes_.size(); ++i) mass_[i] += weight_[p][i] * s_.m[p];
  }

  Array<Vec<D>> mapped_velocity() const {
    Array<Vec<D>> v(nodes_.size(), Vec<D>::Zero());
    for (std::size_t p = 0; p < s_.size(); ++p)
      for (std::size_t i = 0; i < nodes_.size(); ++i) v[i] += weight_[p][i] * s_.m[p] * s_.v[p] / mass_[i];
    return v;
  }

  Array<Vec<D>> acceleration() const {
    Array<Vec<D>> a(nodes_.size(), Vec<D>::Zero());
    for (std::size_t p = 0; p < s_.size(); ++p) {
      const double J = s_.F[p].determinant();  // S (46)
      const Mat<D> sigma = lambda_ * std::log(J) / J * Mat<D>::Identity() +
                           mu_ / J * (s_.F[p] * s_.F[p].transpose() - Mat<D>::Identity());
      for (std::size_t i = 0; i < nodes_.size(); ++i) a[i] -= sigma * gradient_[p][i] * J * s_.V0[p] / mass_[i];
    }
    return a;
  }

  Array<Mat<D>> deformed(const Array<Vec<D>>& v, double dt) const {
    auto F = s_.F;
    for (std::size_t p = 0; p < s_.size(); ++p) {
      Mat<D> L = Mat<D>::Zero();
      for (std::size_t i = 0; i < nodes_.size(); ++i) L += v[i] * gradient_[p][i].transpose();
      F[p] = (Mat<D>::Identity() + dt * L) * F[p];
    }
    return F;
  }

  void move(const Array<Vec<D>>& v, const Array<Vec<D>>& a, double dt) {
    for (std::size_t p = 0; p < s_.size(); ++p)
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        s_.x[p] += dt * weight_[p][i] * v[i];
        s_.v[p] += dt * weight_[p][i] * a[i];
      }
  }

  double h_;
  int n_;
  double lambda_, mu_;
  Particles<D> s_;
  Array<Vec<D>> nodes_;
  std::vector<double> mass_;
  std::vector<std::vector<double>> weight_;
  std::vector<Array<Vec<D>>> gradient_;
};

constexpr int cells_of(int D) {
  return D == 1 ? 24 : D == 2 ? 16 : 5;
}
constexpr int ppc_of(int D) {
  return D == 1 ? 3 : D == 2 ? 1 : 2;
}

/// A wave in a body that drifts and is wrapped, on a line and in the plane through several slabs, so that particles are
/// sorted on the way.
template <int D>
void expect_textbook(std::string_view integrator, void (Textbook<D>::*advance)(double)) {
  Scene<D> scene = full_scene<D>(BSpline2{}, cells_of(D), ppc_of(D));
  set_wave(scene, 4);
  for (auto& v : scene.particles.v) v.array() += 80;
  scene.integrator = integrator;
  const double dt = 0.2 * scene.h / 120;
  Textbook<D> textbook(scene);
  Mpm<D> mpm(scene);
  bool sorted = false;
  for (int k = 0; k < (D == 1 ? 150 : D == 2 ? 40 : 15); ++k) {  // through twenty, five and two cells
    ASSERT_TRUE(mpm.step(dt)) << mpm.fault();
    (textbook.*advance)(dt);
    sorted = sorted || !std::is_sorted(mpm.particles().id.begin(), mpm.particles().id.end());
  }
  EXPECT_TRUE(sorted || D == 3);
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    const std::size_t id = mpm.particles().id[p];
    Vec<D> difference = mpm.particles().x[p] - textbook.particles().x[id];
    for (int d = 0; d < D; ++d) difference[d] -= std::round(difference[d]);
    EXPECT_LT(difference.norm(), 1e-12);
    EXPECT_LT((mpm.particles().v[p] - textbook.particles().v[id]).norm(), 1e-10);
    EXPECT_LT((mpm.particles().F[p] - textbook.particles().F[id]).norm(), 1e-11);
  }
}

TEST(Textbook, UslIn1D) {
  expect_textbook<1>("usl", &Textbook<1>::usl);
}
TEST(Textbook, UslIn2D) {
  expect_textbook<2>("usl", &Textbook<2>::usl);
}
TEST(Textbook, UslIn3D) {
  expect_textbook<3>("usl", &Textbook<3>::usl);
}
TEST(Textbook, UsfIn1D) {
  expect_textbook<1>("usf", &Textbook<1>::usf);
}
TEST(Textbook, UsfIn2D) {
  expect_textbook<2>("usf", &Textbook<2>::usf);
}
TEST(Textbook, UsfIn3D) {
  expect_textbook<3>("usf", &Textbook<3>::usf);
}
TEST(Textbook, UvfIn1D) {
  expect_textbook<1>("uvf", &Textbook<1>::uvf);
}
TEST(Textbook, UvfIn2D) {
  expect_textbook<2>("uvf", &Textbook<2>::uvf);
}
TEST(Textbook, UvfIn3D) {
  expect_textbook<3>("uvf", &Textbook<3>::uvf);
}
TEST(Textbook, UsavgIn1D) {
  expect_textbook<1>("usavg", &Textbook<1>::usavg);
}
TEST(Textbook, UsavgIn2D) {
  expect_textbook<2>("usavg", &Textbook<2>::usavg);
}
TEST(Textbook, UsavgIn3D) {
  expect_textbook<3>("usavg", &Textbook<3>::usavg);
}
TEST(Textbook, UslPlusIn1D) {
  expect_textbook<1>("usl+", &Textbook<1>::usl_plus);
}
TEST(Textbook, UslPlusIn2D) {
  expect_textbook<2>("usl+", &Textbook<2>::usl_plus);
}
TEST(Textbook, UslPlusIn3D) {
  expect_textbook<3>("usl+", &Textbook<3>::usl_plus);
}
TEST(Textbook, UsavgPlusIn1D) {
  expect_textbook<1>("usavg+", &Textbook<1>::usavg_plus);
}
TEST(Textbook, UsavgPlusIn2D) {
  expect_textbook<2>("usavg+", &Textbook<2>::usavg_plus);
}
TEST(Textbook, UsavgPlusIn3D) {
  expect_textbook<3>("usavg+", &Textbook<3>::usavg_plus);
}
TEST(Textbook, RungeKuttaIn1D) {
  expect_textbook<1>("rk4", &Textbook<1>::rk4);
}
TEST(Textbook, RungeKuttaIn2D) {
  expect_textbook<2>("rk4", &Textbook<2>::rk4);
}
TEST(Textbook, RungeKuttaIn3D) {
  expect_textbook<3>("rk4", &Textbook<3>::rk4);
}

}  // namespace mpmvv::solver::textbook_test
