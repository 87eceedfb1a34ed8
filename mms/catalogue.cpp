#include "mms/catalogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mms/at_rest.hpp"
#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "mms/inverse.hpp"
#include "mms/pulse.hpp"
#include "mms/radial_profile.hpp"
#include "mms/ring.hpp"
#include "mms/shell.hpp"
#include "mms/square.hpp"
#include "mms/stretch.hpp"
#include "mms/translation.hpp"
#include "mms/vortex.hpp"
#include "mms/wave.hpp"

namespace mpmvv::mms {

namespace {

/// Returns the shortest text that reads back as the same number.
std::string text(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}
std::string short_text(double value) {
  std::array<char, 32> digits;
  return {digits.data(),
          std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 4).ptr};
}

std::string radii_objection(const Values& values) {
  const double inner = values.at("inner_radius"), outer = values.at("outer_radius");
  return inner < outer ? "" : "inner_radius " + text(inner) + " is not below outer_radius " + text(outer);
}

/// Returns what is wrong with the parameters of a radial motion, W (60) to (62).
std::string radial_objection(const Values& values) {
  if (const std::string objection = radii_objection(values); !objection.empty()) return objection;
  const Radii r = radii(values);
  if (std::abs(r.outer - 3 * r.inner) < 1e-9 * r.outer)
    return "outer_radius " + text(r.outer) + " is three times inner_radius " + text(r.inner) +
           ", where W (61) is singular (any other ratio)";
  const double amplitude = values.at("amplitude"), most = 1 / RadialProfile(r).steepest();
  if (std::abs(amplitude) < most) return "";
  return "amplitude " + text(amplitude) + " makes det F negative (below " + short_text(most) + " between these radii)";
}

std::string pulse_objection(const Values& values) {
  const double c = std::sqrt(values.at("youngs_modulus") / values.at("density"));
  if (1.5 * values.at("duration") * c < pulse_length) return "";
  return "the wave meets the other end: 1.5 duration sqrt(youngs_modulus/density) must be less than 0.2 m";
}

Parameter inner_radius(double value) {
  return {"inner_radius", value, "m", [](double r) { return r > 0; }, "> 0"};
}
Parameter outer_radius(double value) {
  return {"outer_radius", value, "m", [](double r) { return r > 0; }, "> 0"};
}
Parameter any(const char* name, double value, const char* unit) {
  return {name, value, unit, [](double) { return true; }, "any"};
}
Parameter radial_amplitude() {
  return {"amplitude", 0.1, "m", [](double) { return true; }, "small enough that det F stays positive"};
}

/// Makes a solution that depends on an amplitude and a material alone.
template <int D, class S>
std::shared_ptr<ManufacturedSolution<D>> aligned(const Values& values) {
  return std::make_shared<S>(values.at("amplitude"), elasticity(values));
}
template <int D, class S>
std::shared_ptr<ManufacturedSolution<D>> radial(const Values& values) {
  return std::make_shared<S>(values.at("amplitude"), radii(values), elasticity(values));
}

std::shared_ptr<ManufacturedSolution<2>> vortex(const Values& values) {
  return std::make_shared<Vortex>(values.at("amplitude"), radii(values), values.at("period"), elasticity(values));
}

/// The largest displacement of interest is 2 m: that of the ends of a bar from -10 to 10 m, stretched by a fifth.
template <int D>
std::shared_ptr<ManufacturedSolution<D>> stretch(const Values& values) {
  return std::make_shared<Stretch<D>>(values.at("rate"), elasticity(values), 2);
}

std::shared_ptr<ManufacturedSolution<2>> pulse(const Values& values) {
  return std::make_shared<Pulse>(values.at("stress"), values.at("duration"), values.at("youngs_modulus"),
                                 values.at("density"));
}

/// Its displacement scale is a quarter of the square's length, and not the way that it goes: in a periodic square of
/// unit length no displacement errs by more than 0.71 m, half of the diagonal.
std::shared_ptr<ManufacturedSolution<2>> translation(const Values& values) {
  return std::make_shared<Translation<2>>(Vec<2>(values.at("velocity_x"), values.at("velocity_y")), 0.25);
}

Entry aligned_entry(std::string_view name, std::string_view what, double amplitude, int k, auto make) {
  return {.name = name,
          .what = what,
          .parameters = {amplitude_parameter(amplitude, k), youngs_modulus_parameter(1e4),
                         poissons_ratio_parameter(0.3), density_parameter(1)},
          .make = make};
}

Entry bar_entry(std::string_view name, std::string_view what, auto make) {
  return {.name = name,
          .what = what,
          .parameters = {amplitude_parameter(0.05, 2), youngs_modulus_parameter(1e4), density_parameter(1)},
          .make = make};
}

Entry radial_entry(std::string_view name, std::string_view what, auto make) {
  return {.name = name,
          .what = what,
          .parameters = {radial_amplitude(), inner_radius(0.5), outer_radius(1), youngs_modulus_parameter(1e4),
                         poissons_ratio_parameter(0), density_parameter(1)},
          .objection = radial_objection,
          .make = make};
}

Entry stretch_entry(std::string_view name, auto make) {
  return {.name = name,
          .what = "bar that walls at its ends stretch at a constant rate, Nairn and Hammerquist 2021",
          .parameters = {youngs_modulus_parameter(0.75),
                         density_parameter(1),
                         {"rate", 0.0025, "1/s", [](double rate) { return rate > 0; }, "> 0"}},
          .make = make};
}

Entry vortex_entry() {
  return {.name = "vortex",
          .what = "generalized vortex, Kamojjala, Brannon, Sadeghirad and Guilkey 2015",
          .parameters = {any("amplitude", 1, "rad"),
                         inner_radius(0.75),
                         outer_radius(1.25),
                         {"period", 1, "s", [](double t) { return t > 0; }, "> 0"},
                         youngs_modulus_parameter(1000),
                         poissons_ratio_parameter(0.3),
                         density_parameter(1000)},
          .objection = radii_objection,
          .make = &vortex};
}

Entry pulse_entry() {
  return {.name = "pulse",
          .what = "traction pulse that runs through a linear elastic bar, Nairn and Hammerquist 2021",
          .parameters = {youngs_modulus_parameter(1e7),
                         density_parameter(1000),
                         {"stress", 500, "Pa", [](double s) { return s != 0; }, "not 0"},
                         {"duration", 1e-3, "s", [](double t) { return t > 0; }, "> 0"}},
          .objection = pulse_objection,
          .make = &pulse};
}

Entry translation_entry() {
  return {.name = "translation",
          .what = "body that moves as a whole at a constant velocity",
          .parameters = {any("velocity_x", 30, "m/s"), any("velocity_y", 18.5, "m/s"), youngs_modulus_parameter(1e4),
                         poissons_ratio_parameter(0.3), density_parameter(1)},
          .make = &translation};
}

}  // namespace

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> entries{
      bar_entry("bar", "periodic bar, Steffen et al. 2008", &aligned<1, Bar>),
      bar_entry("bar-rest", "the bar's motion from rest", &aligned<1, BarAtRest>),
      aligned_entry("square", "unit square in plane strain, Wallstedt and Guilkey 2008", 0.1, 1, &aligned<2, Square>),
      aligned_entry("square-rest", "the square's motion from rest", 0.02, 1, &aligned<2, SquareAtRest>),
      aligned_entry("square-inverse", "square from rest whose body force is given at the current position", 0.02, 1,
                    &aligned<2, SquareInverse>),
      aligned_entry("cube", "periodic unit cube, Steffen et al. 2008", 0.05, 2, &aligned<3, Cube>),
      aligned_entry("cube-rest", "the cube's motion from rest", 0.02, 2, &aligned<3, CubeAtRest>),
      radial_entry("ring", "ring that expands and contracts, Wallstedt and Guilkey 2008", &radial<2, Ring>),
      radial_entry("shell", "the ring's sister in three dimensions", &radial<3, Shell>),
      vortex_entry(),
      stretch_entry("stretch", &stretch<2>),
      stretch_entry("stretch-1d", &stretch<1>),
      stretch_entry("stretch-3d", &stretch<3>),
      pulse_entry(),
      aligned_entry("wave", "standing wave of small strain, without a body force", 1e-3, 1, &aligned<2, Wave>),
      translation_entry()};
  return entries;
}

const Entry& entry_named(std::string_view name) {
  const auto found = std::ranges::find(catalogue(), name, &Entry::name);
  if (found != catalogue().end()) return *found;
  std::string known;
  for (const Entry& entry : catalogue()) known += (known.empty() ? "" : ", ") + std::string(entry.name);
  throw UnknownName("unknown solution '" + std::string(name) + "' (known: " + known + ")");
}

Values complete(const Entry& entry, const Values& given) {
  Values values;
  for (const Parameter& parameter : entry.parameters) values[parameter.name] = parameter.value;
  for (const auto& [name, value] : given) {
    const auto parameter = std::ranges::find(entry.parameters, name, &Parameter::name);
    const std::string of = " of '" + std::string(entry.name) + "'";
    if (parameter == entry.parameters.end()) {
      std::string known;
      for (const Parameter& one : entry.parameters) known += (known.empty() ? "" : ", ") + one.name;
      throw UnknownName("unknown parameter '" + name + "'" + of + " (known: " + known + ")");
    }
    if (!std::isfinite(value) || !parameter->allowed(value))
      throw std::invalid_argument("parameter '" + name + "'" + of + " is " + text(value) + " (" + parameter->range +
                                  ")");
    values[name] = value;
  }
  if (entry.objection)
    if (const std::string objection = entry.objection(values); !objection.empty())
      throw std::invalid_argument("parameters of '" + std::string(entry.name) + "': " + objection);
  return values;
}

}  // namespace mpmvv::mms
