#include "studies/codes/output_checks.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "studies/cases/setting_keys.hpp"
#include "studies/codes/excursion.hpp"
#include "studies/codes/matching.hpp"
#include "studies/codes/output_fault.hpp"
#include "studies/codes/rounding.hpp"
#include "studies/codes/text_column.hpp"
#include "studies/codes/units.hpp"

namespace mpmvv::codes {

using records::Status;

namespace {

/// Whether two texts are the same, or both are numbers and differ by at most 1e-6 of the second.
bool are_same(const std::string& a, const std::string& b) {
  TableColumn numbers;
  if (!add_text(numbers, a) || !add_text(numbers, b)) return a == b;
  return std::abs(numbers.values[0] - numbers.values[1]) <= 1e-6 * std::abs(numbers.values[1]);
}

/// Whether a setting says what is solved, whichever code solves it. Other codes have words of their own for methods.
bool is_of_any_code(const cases::SettingKey& setting, const cases::Case& c) {
  if (!setting.member || setting.member->part == cases::CasePart::measure) return false;
  return setting.of == cases::KeyOf::every || setting.key == "boundary" ||
         (setting.key == "force_form" && setting.is_of(c.scheme.code));
}

/// Whether a text is the Courant number of the case, or a larger one from which its time step was made: the largest
/// step up to it that divides the end time.
bool is_cfl(const cases::Case& c, const std::string& said) {
  TableColumn number;
  if (!add_text(number, said)) return false;
  const double ratio = number.values[0] / problems::cfl_number(c);
  return ratio > 1 - 2e-3 && ratio < 1 + 2e-3 + c.resolution.dt / c.problem.end_time;
}

/// Returns the value that the case has for a key of a file; empty if the case has no such key.
std::string value_of(const cases::Case& c, const std::string& key) {
  if (key == "problem") return c.problem.name;
  if (key == "end_time") return fmt::format("{}", c.problem.end_time);
  if (const auto it = c.problem.parameters.find(key); it != c.problem.parameters.end())
    return fmt::format("{}", it->second);
  for (const cases::SettingKey& setting : cases::setting_keys())
    if (setting.key == key && is_of_any_code(setting, c)) return cases::text_of(setting.member->value(c));
  return "";
}

/// Returns the unit that values of the key have in a case; empty if they have none.
std::string unit_of(const cases::Case& c, const std::string& key) {
  const auto& parameters = problems::find_problem(c.problem.name, "the case").parameters;
  const auto parameter = std::ranges::find(parameters, key, &problems::Parameter::name);
  if (parameter != parameters.end()) return std::string(parameter->unit);
  return key == "dt" || key == "end_time" ? "s" : "";
}

/// Returns the text without this unit behind a number, as in `0.25 s`.
std::string without_unit(const std::string& text, const std::string& unit) {
  const bool has_it = !unit.empty() && text.ends_with(" " + unit);
  return has_it ? text.substr(0, text.size() - unit.size() - 1) : text;
}

void require_same_case(const cases::Case& c, const SnapshotPart& part, bool has_own_units) {
  for (const auto& [key, text] : part.says) {
    const std::string unit = unit_of(c, key), said = without_unit(text, unit);
    if (has_own_units && !unit.empty()) continue;
    if (key == "cfl" && !is_cfl(c, said))
      fail_output("cfl = {} in {}, the case has {:.4g}", said, part.file, problems::cfl_number(c));
    if (const std::string value = value_of(c, key); !value.empty() && !are_same(said, value))
      fail_output("{} = {} in {}, the case has {}", key, said, part.file, value);
  }
}

template <std::size_t N>
void require_finite(const std::vector<std::array<double, N>>& all, const char* what, const Snapshot& s) {
  const auto is_finite = [](const auto& each) {
    return std::all_of(each.begin(), each.end(), [](double value) { return std::isfinite(value); });
  };
  const auto first = std::find_if_not(all.begin(), all.end(), is_finite);
  if (first == all.end()) return;
  const auto count = all.end() - first - std::count_if(first, all.end(), is_finite);
  throw OutputFault(
      Status::unstable,
      fmt::format("{} of {} particles with a {} that is no number in {} (the first: {})", count, all.size(), what,
                  s.file, name_of_particle(s, static_cast<std::size_t>(first - all.begin()))));
}

/// Returns how far a ratio of displacements may be off a factor between units. Displacements that are written alone may
/// be further off, as those of a coarse grid are, unless the exact ones are small at the end.
template <int D>
double band_of_displacements(const MatchedEnd<D>& end) {
  if (!end.snapshot.x.empty()) return 1.05;
  const Excursion exact = excursion(end.particles);
  return exact.at_end > exact.farthest / 4 ? 1.25 : 1.05;
}

/// Returns the RMS error of every `stride`th line against the exact solution at time t.
template <int D>
double error_at(const MatchedEnd<D>& end, double t, std::size_t stride) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t line = 0; line < end.size(); line += stride, ++count) squares += end.error(line, t).squaredNorm();
  return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

void require_same_case(const cases::Case& c, const Snapshot& s) {
  if (s.parts.empty()) require_same_case(c, {s.file, s.size(), s.says}, s.has_own_units);
  for (const SnapshotPart& part : s.parts) require_same_case(c, part, s.has_own_units);
}

void require_last_step(const cases::Case& c, const Snapshot& s) {
  const std::int64_t steps = c.resolution.steps;
  if (s.step && *s.step != 0 && *s.step != steps)
    fail_output("{} is of step {} and not of the last one, {}", s.file, *s.step, steps);
}

bool is_end_time(const cases::Case& c, double time) {
  const double T = static_cast<double>(c.resolution.steps) * c.resolution.dt;
  return std::abs(time - T) <= std::max(1e-3 * c.resolution.dt, 2e-6 * T);
}

void require_end_time(const cases::Case& c, const Snapshot& s) {
  if (s.time && !is_end_time(c, *s.time))
    fail_output("time {:.9g} s in {}, the case ends at {:.9g} s", *s.time, s.file,
                static_cast<double>(c.resolution.steps) * c.resolution.dt);
}

void require_finite(const Output& output, std::size_t particles) {
  try {
    for (const Snapshot* s : {output.start ? &*output.start : nullptr, &output.end}) {
      if (!s) continue;
      require_finite(s->x, "position", *s);
      require_finite(s->u, "displacement", *s);
      require_finite(s->v, "velocity", *s);
    }
  } catch (const OutputFault&) {
    require_each_once(output, particles);
    throw;
  }
}

template <int D>
void require_length_units(const MatchedEnd<D>& end) {
  std::vector<Vec<D>> x, u, x_wanted, u_wanted;
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D>& X = end.particles.X[end.particle[line]];
    u.push_back(end.u[line]);
    x.push_back(end.x(line));
    u_wanted.push_back(end.particles.setup.solution->u(X, end.particles.end_time));
    x_wanted.push_back(X + u_wanted.back());
  }
  const std::string& file = end.snapshot.file;
  if (const double factor = factor_between(from_middle(x), from_middle(x_wanted)); factor != 1)
    fail_units("positions", factor, file);
  if (const double factor = factor_between(u, u_wanted, band_of_displacements(end)); factor != 1)
    fail_units("displacements", factor, file);
}

template <int D>
void require_velocity_units(const MatchedEnd<D>& end) {
  const auto square = [&](const Vec<D>& X, double t) { return end.particles.setup.solution->v(X, t).squaredNorm(); };
  if (end.snapshot.v.empty() || !is_large_at_end(end.particles, square)) return;
  std::vector<Vec<D>> v, v_wanted;
  for (std::size_t line = 0; line < end.snapshot.v.size(); ++line) {
    v.push_back(vec<D>(end.snapshot.v[line]));
    v_wanted.push_back(end.particles.setup.solution->v(end.particles.X[end.particle[line]], end.particles.end_time));
  }
  if (const double factor = factor_between(v, v_wanted, 2); factor != 1)
    fail_output(
        "velocities in {} are about {:g} times those of the case (another unit? --time-unit, or units of the adapter)",
        end.snapshot.file, factor);
}

template <int D>
std::string common_offset(const MatchedEnd<D>& end) {
  std::vector<Vec<D>> offsets;
  Vec<D> mean = Vec<D>::Zero();
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D>& X = end.particles.X[end.particle[line]];
    offsets.push_back(end.x(line) - X - end.particles.setup.solution->u(X, end.particles.end_time));
    mean += offsets.back() / static_cast<double>(end.size());
  }
  const auto is_near = [&mean](const Vec<D>& offset) { return (offset - mean).norm() < 0.1 * mean.norm(); };
  if (end.size() < 2 || !std::ranges::all_of(offsets, is_near)) return "";
  for (double& component : mean)
    if (std::abs(component) < 1e-3 * mean.norm()) component = 0;
  return fmt::format("; all particles are off by about ({:.3g}) m: another origin?", fmt::join(mean, ", "));
}

template <int D>
void require_inside(const MatchedEnd<D>& end) {
  const CaseParticles<D>& all = end.particles;
  for (std::size_t line = 0; line < end.size(); ++line)
    for (int d = 0; d < D; ++d) {
      const double x = end.x(line)[d];
      if (all.period[d] > 0 || (x > all.lower[d] - all.h && x < all.upper[d] + all.h)) continue;
      throw OutputFault(
          Status::unstable,
          fmt::format("particle {} has escaped: {} = {:.3g} m in {} (the grid is from {:.3g} to {:.3g} m){}",
                      end.particle[line] + 1, "xyz"[d], x, end.snapshot.file, all.lower[d], all.upper[d],
                      common_offset(end)));
    }
}

template <int D>
void require_time(const MatchedEnd<D>& end) {
  constexpr std::size_t lines = 500;
  constexpr int times = 400;
  const double T = end.particles.end_time;
  const std::size_t stride = (end.size() + lines - 1) / lines;
  const double error = error_at(end, T, stride);
  if (!(error > 0.02 * end.particles.setup.solution->displacement_scale())) return;
  const double least = std::max(1.5 * end.particles.dt, 0.08 * T);  // a smaller shift is a phase lag, which is an error
  double best = error, when = T;
  for (int k = 0; k <= times; ++k) {
    const double t = 2 * T * k / times;
    if (const double other = error_at(end, t, stride); std::abs(t - T) > least && other < best) best = other, when = t;
  }
  if (!(best < error / 5)) return;
  const std::string stated = end.snapshot.has_own_units ? "..., in its unit," : fmt::format("{:.9g}", T);
  fail_output(
      "another time in {}? It is {:.2g} m from the exact solution of {:.4g} s, {:.2g} m from that of {:.4g} s, and "
      "states no time (if it is of the end, let it say so: # time = {} in a text, a column 'time', TimeValue in a "
      ".vtu; an adapter can add it with [[output.convert]] and {{{{end_time}}}})",
      end.snapshot.file, best, when, error, T, stated);
}

template <int D>
void require_motion(const MatchedEnd<D>& end) {
  const double least = 1e-9 * end.particles.setup.solution->displacement_scale() +
                       2 * rounding_error(end.snapshot.rounding);  // numbers on a lattice may all be off by half a unit
  if (error_at(end, 0, 1) > least) return;
  const Excursion exact = excursion(end.particles);
  if (exact.farthest <= 10 * least) return;
  if (exact.at_end <= least)
    fail_output(
        "the particles in {} are where they were at time zero, and so are those of the exact solution: nothing can be "
        "told from them (a case with another --end-time, such as {:.3g})",
        end.snapshot.file, exact.time);
  fail_output("no particle in {} has moved since time zero (the state at the end of a run)", end.snapshot.file);
}

template <int D>
void require_mass(const MatchedEnd<D>& end) {
  const Snapshot& s = end.snapshot;
  if (s.mass.empty()) return;
  const auto odd = std::ranges::find_if_not(s.mass, [](double m) { return m > 0 && std::isfinite(m); });
  if (odd != s.mass.end())
    fail_output("{} in {} has mass {:g} kg (a positive one)",
                name_of_particle(s, static_cast<std::size_t>(odd - s.mass.begin())), s.file, *odd);
  const double wanted = std::accumulate(end.particles.m.begin(), end.particles.m.end(), 0.0);
  const double mass = std::accumulate(s.mass.begin(), s.mass.end(), 0.0);
  if (!(std::abs(mass / wanted - 1) <= 0.02))
    fail_output("mass {:.4g} kg in {}, {:.4g} times that of the case ({})", mass, s.file, mass / wanted,
                D == 2
                    ? "which is 1 m thick: --thickness, or thickness in units of the adapter; or another unit of mass, "
                      "and so of stress: --mass-unit, or units of the adapter"
                    : "its unit: --mass-unit, or units of the adapter");
}

template void require_length_units(const MatchedEnd<1>&);
template void require_length_units(const MatchedEnd<2>&);
template void require_length_units(const MatchedEnd<3>&);
template void require_velocity_units(const MatchedEnd<1>&);
template void require_velocity_units(const MatchedEnd<2>&);
template void require_velocity_units(const MatchedEnd<3>&);
template std::string common_offset(const MatchedEnd<1>&);
template std::string common_offset(const MatchedEnd<2>&);
template std::string common_offset(const MatchedEnd<3>&);
template void require_inside(const MatchedEnd<1>&);
template void require_inside(const MatchedEnd<2>&);
template void require_inside(const MatchedEnd<3>&);
template void require_time(const MatchedEnd<1>&);
template void require_time(const MatchedEnd<2>&);
template void require_time(const MatchedEnd<3>&);
template void require_motion(const MatchedEnd<1>&);
template void require_motion(const MatchedEnd<2>&);
template void require_motion(const MatchedEnd<3>&);
template void require_mass(const MatchedEnd<1>&);
template void require_mass(const MatchedEnd<2>&);
template void require_mass(const MatchedEnd<3>&);

}  // namespace mpmvv::codes
