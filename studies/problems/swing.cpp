#include "mms/derived.hpp"
#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

using std::numbers::pi;

/// u_x = A cos πX sin Cπt,   u_y = Vt + A sin 2πY sin Cπt.   At X = 0 and 1 there is no strain along x.
struct Swing {
  double amplitude, wave_speed, drift;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::cos, std::sin;
    const T swing = amplitude * sin(wave_speed * pi * t);
    return {swing * cos(pi * X[0]), drift * t + swing * sin(2 * pi * X[1])};
  }
};

/// The wall at the end X of the square. Its displacement is `amplitude` sin Cπt; the amplitude is A at 0 and -A at 1.
class SwingingWall final : public solver::WallMotion {
 public:
  SwingingWall(double X, double amplitude, double wave_speed) : X_(X), amplitude_(amplitude), rate_(pi * wave_speed) {}

  double position(double t) const override { return X_ + amplitude_ * std::sin(rate_ * t); }
  double velocity(double t) const override { return amplitude_ * rate_ * std::cos(rate_ * t); }
  double gradient(double) const override { return 0; }

 private:
  double X_, amplitude_, rate_;
};

Setup<2> swing_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  const double A = p.at("amplitude"), C = bar_wave_speed(p);
  auto solution = mms::derived<2>(Swing{A, C, p.at("drift")}, material, std::abs(A));
  Setup<2> setup{
      .body =
          Box<2>{.lower = solver::Vec<2>::Zero(), .size = solver::Vec<2>::Ones(), .end_speed = std::abs(A) * pi * C},
      .density = material.density,
      .material = material_of(p),
      .solution = std::make_shared<decltype(solution)>(solution)};
  setup.walls[0] = std::make_shared<SwingingWall>(0, A, C);
  setup.walls[1] = std::make_shared<SwingingWall>(1, -A, C);
  return setup;
}

}  // namespace

/// The unit square in plane strain between walls that swing at the frequency C/2, while it drifts through its periodic
/// sides. It is from no paper. No other problem has walls that accelerate, or both walls and periodic faces. The end
/// time is half a period.
Problem swing_problem() {
  return {
      .name = "swing",
      .source = "made for the gate",
      .length_formula = "1",
      .length = unit_length,
      .parameters = {mms::amplitude_parameter(0.05, 2), youngs_modulus_parameter(1e4), poissons_ratio_parameter(0.3),
                     density_parameter(1), Parameter{"drift", 30, "m/s", [](double) { return true; }, "any"}},
      .wave_speed_formula = "c = sqrt(E/rho)",
      .wave_speed = bar_wave_speed,
      .end_time_formula = "1/c",
      .end_time = [](const Parameters& p) { return 1 / bar_wave_speed(p); },
      .boundary = "xmin=wall,xmax=wall,ymin=periodic,ymax=periodic",
      .setup = &swing_setup};
}

}  // namespace mpmvv::problems
