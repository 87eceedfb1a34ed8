#include "studies/cases/case.hpp"

#include <fmt/format.h>

namespace mpmvv::cases {

namespace {

/// Collects `key=value` pairs; numbers in their shortest text that reads back as the same number.
class CanonicalLine {
 public:
  template <class T>
  CanonicalLine& add(const std::string& key, const T& value) {
    text_ += fmt::format("{}{}={}", text_.empty() ? "" : " ", key, value);
    return *this;
  }
  CanonicalLine& add(const std::string& key, double value) {
    return add<double>(key, value + 0.0);
  }  // -0 equals 0: one text

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string canonical_text(const Case& c) {
  // Structured bindings name every member, so a new one does not compile until it stands here as well.
  const auto& [problem, scheme, resolution, measure] = c;
  const auto& [name, parameters, end_time, quarter] = problem;
  const auto& [basis, smoothing_length, integrator, start, velocity_update, order, cfl_x, position, wall_method,
               wall_depth, wall_gradient, mass, boundary, wall_acceleration, deformation, body_force, fill, material] =
      scheme;
  const auto& [cells, ppc, grid_offset, shuffle, dt, steps] = resolution;
  const auto& [every_step, nodal_error, velocity_error, stress_error, blowup_error, blowup_energy, repeat] = measure;

  CanonicalLine line;
  line.add("problem", name);
  for (const auto& [key, value] : parameters) line.add("param." + key, value);
  line.add("end_time", end_time)
      .add("quarter", quarter)
      .add("basis", basis)
      .add("smoothing_length", smoothing_length)
      .add("integrator", integrator)
      .add("start", start)
      .add("velocity_update", velocity_update)
      .add("order", order)
      .add("cfl_x", cfl_x)
      .add("position", position)
      .add("wall_method", wall_method)
      .add("wall_depth", wall_depth)
      .add("wall_gradient", wall_gradient)
      .add("mass", mass)
      .add("boundary", boundary)
      .add("wall_acceleration", wall_acceleration)
      .add("deformation", deformation)
      .add("body_force", body_force)
      .add("fill", fill)
      .add("material", material)
      .add("cells", cells)
      .add("ppc", ppc)
      .add("grid_offset", grid_offset)
      .add("shuffle", shuffle)
      .add("dt", dt)
      .add("steps", steps)
      .add("every_step", every_step)
      .add("nodal_error", nodal_error)
      .add("velocity_error", velocity_error)
      .add("stress_error", stress_error)
      .add("blowup_error", blowup_error)
      .add("blowup_energy", blowup_energy)
      .add("repeat", repeat);
  return line.text();
}

std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace mpmvv::cases
