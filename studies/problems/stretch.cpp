#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

constexpr double bar_length = 20, bar_height = 4;  // m

/// The wall at the end X of the bar, which moves at a constant velocity.
class BarEnd final : public solver::WallMotion {
 public:
  BarEnd(double X, double rate) : X_(X), rate_(rate) {}

  double position(double t) const override { return X_ * (1 + rate_ * t); }
  double velocity(double) const override { return X_ * rate_; }
  double gradient(double t) const override { return rate_ / (1 + rate_ * t); }

 private:
  double X_, rate_;
};

template <int D>
Setup<D> stretch_setup(const Parameters& p) {
  constexpr const char* names[] = {"stretch-1d", "stretch", "stretch-3d"};
  const double rate = p.at("rate"), end_speed = rate * bar_length / 2;
  Setup<D> setup = setup_of<D>(names[D - 1], p);
  setup.material = material_of<solver::NeoHookeanSquare>(p);
  Box<D> bar{.lower = solver::Vec<D>::Constant(-bar_height / 2), .size = solver::Vec<D>::Constant(bar_height)};
  bar.lower[0] = -bar_length / 2, bar.size[0] = bar_length, bar.end_speed = end_speed;
  setup.body = bar;
  for (const std::size_t face : {0, 1})
    setup.walls[face] = std::make_shared<BarEnd>((face == 0 ? -1 : 1) * bar_length / 2, rate);
  setup.speed = end_speed;
  return setup;
}

template <int D>
Problem stretch_in(const std::string& name, const std::string& sides) {
  return {.name = name,
          .source = "Nairn and Hammerquist 2021, section 3.4",
          .length_formula = "4",
          .length = [](const Parameters&) { return bar_height; },
          .parameters = mms::entry_named(name).parameters,
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "0.2/rate",
          .end_time = [](const Parameters& p) { return 0.2 / p.at("rate"); },
          .boundary = "xmin=wall,xmax=wall" + sides,
          .material = std::string(solver::NeoHookeanSquare::word),
          .images = D > 1 ? solver::Images::middle : solver::Images::none,
          .setup = &stretch_setup<D>};
}

}  // namespace

/// A bar of 20 by 4 m (by 4 m in three dimensions, a line in one) centred at the origin. Walls at its ends stretch it
/// by a fifth. Its Poisson's ratio is zero, and its sides are free. L is its height, so that N's cells of 0.25 m are
/// `cells` = 16.
Problem stretch_problem() {
  return stretch_in<2>("stretch", ",ymin=free,ymax=free");
}

Problem stretch_1d_problem() {
  return stretch_in<1>("stretch-1d", "");
}

Problem stretch_3d_problem() {
  return stretch_in<3>("stretch-3d", ",ymin=free,ymax=free,zmin=free,zmax=free");
}

}  // namespace mpmvv::problems
