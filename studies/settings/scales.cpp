#include "studies/settings/scales.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/cases/setting.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::has_size;
using cases::largest_size;
using cases::least_size;
using problems::Problem;

namespace {

using solver::Vec;

std::string size_text(double value) {
  if (std::isnan(value)) return "not a number";
  return std::isinf(value) ? "infinite" : fmt::format("{:.3g}", value);
}

/// Throws UsageError where a quantity that follows from a problem's values has no size that a run can work with.
class Scales {
 public:
  Scales(const Problem& problem, const std::string& given) : problem_(problem), given_(given) {}

  void require(const std::string& what, double value, const char* unit) const {
    if (value <= 0 || !has_size(value)) refuse(what, value, unit);
  }
  void require_or_none(const std::string& what, double value, const char* unit) const {
    if (value != 0) require(what, value, unit);
  }
  /// For quantities that may pass through zero: refuses only too large ones.
  void require_bounded(const std::string& what, double value, const char* unit) const {
    if (!(value <= largest_size)) refuse(what, value, unit);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, double value, const char* unit) const {
    throw support::UsageError(fmt::format("the {} of problem '{}' is {} {}{} (a number from {} to {})", what,
                                          problem_.name, size_text(value), unit, given_, least_size, largest_size));
  }

  const Problem& problem_;
  const std::string& given_;
};

// Return a point of the body where no field vanishes by symmetry.
template <int D>
Vec<D> point_in(const problems::Cuboid<D>& cuboid) {
  return cuboid.lower + Vec<D>::Constant(0.3 * cuboid.length);
}
template <int D>
Vec<D> point_in(const problems::Annulus<D>& annulus) {
  return Vec<D>::Constant((0.7 * annulus.inner + 0.3 * annulus.outer) / std::sqrt(D));
}
template <int D>
Vec<D> point_in(const problems::Blocks<D>& blocks) {
  return 0.3 * blocks.size;
}
template <int D>
Vec<D> point_in(const problems::Box<D>& box) {
  return box.lower + 0.3 * box.size;
}

template <int D>
void require_motion(const Scales& scales, const problems::Setup<D>& setup, double mass, double end_time) {
  const Vec<D> X = std::visit([](const auto& body) { return point_in(body); }, setup.body);
  const auto require_speed = [&](double speed) {
    scales.require_bounded("speed", speed, "m/s");
    scales.require_bounded("kinetic energy", mass * speed * speed, "J");
  };
  if (!setup.solution) return require_speed(setup.start_velocity(X).norm());
  scales.require_or_none("largest displacement", setup.solution->displacement_scale(), "m");
  for (const double t : {0.0, end_time / 3, end_time}) {
    require_speed(setup.solution->v(X, t).norm());
    scales.require_bounded("stress", setup.solution->P(X, t).norm(), "Pa");
    scales.require_bounded("body force", setup.solution->b(X, t).norm(), "m/s2");
  }
}

}  // namespace

void require_scales(const cases::ProblemChoice& choice, const Problem& problem, const std::string& given) {
  const Scales scales(problem, given);
  const double speed = problem.wave_speed(choice.parameters);
  scales.require("length " + problem.length_formula, problem.length(choice.parameters), "m");
  scales.require("wave speed " + problem.wave_speed_formula, speed, "m/s");
  scales.require("end time", choice.end_time, "s");
  const auto require_body = [&]<int D>(problems::SetupFunction<D>) {
    const problems::Setup<D> setup = problems::make_setup<D>(problem, choice, 0);
    const double size = std::visit([](const auto& body) { return problems::volume(body); }, setup.body);
    const double mass = setup.density * size;
    scales.require("volume", size, "m3");
    scales.require("mass", mass, "kg");
    scales.require("stiffness, density times wave speed squared,", setup.density * speed * speed, "Pa");
    scales.require("energy, mass times wave speed squared,", mass * speed * speed, "J");
    require_motion<D>(scales, setup, mass, choice.end_time);
  };
  std::visit(require_body, problem.setup);
}

void require_scales(const cases::Case& c, const Problem& problem, const std::string& given) {
  const Scales scales(problem, given);
  const double h = problem.length(c.problem.parameters) / c.resolution.cells;
  scales.require("cell width", h, "m");
  scales.require("time step", c.resolution.dt, "s");
  scales.require("end time", c.problem.end_time, "s");
  scales.require("CFL number", problem.wave_speed(c.problem.parameters) * c.resolution.dt / h, "cells a step");
  const auto density = std::visit([&](auto make) { return make(c.problem.parameters).density; }, problem.setup);
  const int D = problem.dimension();
  const double volume_of_particle = std::pow(h / c.resolution.ppc, D);
  scales.require("volume of a particle", volume_of_particle, "m3");
  scales.require("mass of a particle", density * volume_of_particle, "kg");
  problems::extent(c);  // throws where the domain has more cells than grids can number
}

}  // namespace mpmvv::settings
