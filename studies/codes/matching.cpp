#include "studies/codes/matching.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "studies/codes/nearest_point.hpp"
#include "studies/codes/output_fault.hpp"
#include "studies/codes/units.hpp"

namespace mpmvv::codes {

namespace {

using Lines = std::vector<std::size_t>;  ///< the particle of each line, by its place in the case

/// Returns the ids of the first three particles that no line has, for messages; empty where it is not known which.
std::string missing(const std::vector<bool>& taken) {
  std::vector<std::size_t> ids;
  const auto all = static_cast<std::size_t>(std::count(taken.begin(), taken.end(), false));
  for (std::size_t p = 0; p < taken.size() && ids.size() < 3; ++p)
    if (!taken[p]) ids.push_back(p + 1);
  return ids.empty() ? "" : fmt::format(" (of the case {}{})", fmt::join(ids, ", "), all > ids.size() ? ", ..." : "");
}

void require_count(const Snapshot& s, std::size_t particles, const std::vector<bool>& taken) {
  if (s.size() < particles)
    fail_output("{} of {} particles are missing in {}{}", particles - s.size(), particles, s.file, missing(taken));
  if (s.size() > particles) fail_output("{} particles in {}, the case has {}", s.size(), s.file, particles);
}

/// Returns the particles by the ids of the lines, which count from 1 in the order in which particles fill the body.
Lines by_case_id(const Snapshot& s, std::size_t particles) {
  Lines found;
  std::vector<bool> taken(particles, false);
  for (const std::int64_t id : s.id) {
    if (id < 1 || id > static_cast<std::int64_t>(particles))
      fail_output(
          "particle {} in {} (the case has particles 1 to {}; a code with ids of its own: --start, or start of the "
          "adapter)",
          id, s.file, particles);
    const auto p = static_cast<std::size_t>(id - 1);
    if (taken[p]) fail_output("particle {} stands twice in {}", id, s.file);
    taken[p] = true;
    found.push_back(p);
  }
  require_count(s, particles, taken);
  return found;
}

void require_distinct_ids(const Snapshot& s) {
  std::unordered_set<std::int64_t> seen;
  for (const std::int64_t id : s.id)
    if (!seen.insert(id).second) fail_output("particle {} stands twice in {}", id, s.file);
}

/// Whether reference positions say which particle a line is, X or x - u.
bool has_reference_places(const Snapshot& s) {
  return !s.X.empty() || (!s.x.empty() && !s.u.empty());
}

/// Returns the particles of the lines at the end: each is that of the line of the start with the same id.
Lines by_start_id(const Snapshot& end, const Snapshot& start, const Lines& of_start) {
  std::unordered_map<std::int64_t, std::size_t> lines;
  for (std::size_t line = 0; line < start.size(); ++line)
    if (!lines.emplace(start.id[line], line).second)
      fail_output("particle {} stands twice in {}", start.id[line], start.file);
  Lines found;
  std::vector<bool> taken(of_start.size(), false);
  for (const std::int64_t id : end.id) {
    const auto line = lines.find(id);
    if (line == lines.end()) fail_output("particle {} of {} is not in {}", id, end.file, start.file);
    found.push_back(of_start[line->second]);
    if (taken[found.back()]) fail_output("particle {} stands twice in {}", id, end.file);
    taken[found.back()] = true;
  }
  require_count(end, of_start.size(), taken);
  return found;
}

/// Moves the places into a periodic grid by whole periods.
template <int D>
std::vector<Vec<D>> inside(const CaseParticles<D>& particles, std::vector<Vec<D>> places) {
  const Vec<D> middle = (particles.lower + particles.upper) / 2;
  for (Vec<D>& place : places) place = middle + particles.difference(place, middle);
  return places;
}

/// Returns the point nearest to a place in a periodic grid, where both are inside: a point at one of its faces, edges
/// or corners is near to places at the others.
template <int D>
Neighbour nearest_around(const CaseParticles<D>& particles, const NearestPoint<D>& nearest, const Vec<D>& place) {
  const Vec<D> middle = (particles.lower + particles.upper) / 2;
  Neighbour best = nearest(place);
  for (int images = 1; images < 1 << D;
       ++images) {  // in each axis the place itself, or its image beyond the other face
    Vec<D> image = place;
    for (int axis = 0; axis < D; ++axis)
      if ((images >> axis & 1) != 0) image[axis] += (place[axis] < middle[axis] ? 1 : -1) * particles.period[axis];
    if (const Neighbour other = nearest(image); other.distance < best.distance) best = other;
  }
  return best;
}

/// Returns for each place the particle whose position in `at` is nearest, one to one. It has to be within a hundredth
/// of the particle spacing plus ten units of rounding.
template <int D>
Lines by_place(const CaseParticles<D>& particles, std::vector<Vec<D>> places, std::vector<Vec<D>> at,
               const Snapshot& s) {
  require_units(places, at, s.file);
  places = inside(particles, std::move(places)), at = inside(particles, std::move(at));
  const NearestPoint<D> nearest(at);
  const double exactly = 0.01 * particles.spacing + 10 * s.rounding;
  std::vector<bool> taken(at.size(), false);
  Lines found;
  double farthest = 0;
  for (std::size_t line = 0; line < places.size(); ++line) {
    const Neighbour neighbour = nearest_around(particles, nearest, places[line]);
    farthest = std::max(farthest, neighbour.distance);
    if (farthest <= exactly && taken[neighbour.point])
      fail_output("two particles in {} start where the case's particle {} does", s.file, neighbour.point + 1);
    taken[neighbour.point] = true;
    found.push_back(neighbour.point);
  }
  if (farthest > exactly)
    fail_output("particles in {} start up to {:.2g} m from those of the case, which are {:.2g} m apart (the same ones)",
                s.file, farthest, particles.spacing);
  require_count(s, at.size(), taken);
  return found;
}

/// Returns the reference positions of the lines: X if it is written, else x - u, inside the grid. Empty if the file has
/// neither.
template <int D>
std::vector<Vec<D>> reference_places(const CaseParticles<D>& particles, const Snapshot& s) {
  std::vector<Vec<D>> places = vecs<D>(s.X);
  if (!places.empty() || !has_reference_places(s)) return places;
  for (std::size_t line = 0; line < s.size(); ++line) places.push_back(vec<D>(s.x[line]) - vec<D>(s.u[line]));
  return inside(particles, std::move(places));
}

template <int D>
Lines of_start(const CaseParticles<D>& particles, const Snapshot& start) {
  if (const auto X = reference_places(particles, start); !X.empty()) return by_place(particles, X, particles.X, start);
  if (start.x.empty()) fail_output("no positions in {} (x at time zero)", start.file);
  return by_place(particles, vecs<D>(start.x), particles.x0, start);
}

/// Counts the lines that are half a spacing or more from the exact position, if `lines` are their particles.
template <int D>
std::size_t strayed(const CaseParticles<D>& particles, const Snapshot& end, const Lines& lines) {
  std::size_t count = 0;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const Vec<D> exact = particles.exact(lines[line], particles.end_time);
    if (!(particles.difference(vec<D>(end.x[line]), exact).norm() < particles.spacing / 2)) ++count;
  }
  return count;
}

/// Returns for each line the particle whose place in `at` is nearest to it. Empty unless all are within half a spacing
/// and no particle is taken twice.
template <int D>
Lines by_nearest(const CaseParticles<D>& particles, std::vector<Vec<D>> at, const Snapshot& end) {
  at = inside(particles, std::move(at));
  const NearestPoint<D> nearest(at);
  std::vector<bool> taken(particles.size(), false);
  Lines found;
  for (const Vec<D>& place : inside(particles, vecs<D>(end.x))) {
    const Neighbour neighbour = nearest_around(particles, nearest, place);
    if (!(neighbour.distance < particles.spacing / 2) || taken[neighbour.point]) return {};
    taken[neighbour.point] = true;
    found.push_back(neighbour.point);
  }
  return found;
}

/// Returns the particles of an end that has neither ids to go by nor reference positions: those of `order` if the exact
/// solution confirms it, else those nearest at time zero. `whose` order it is goes into the message.
template <int D>
Lines by_order(const CaseParticles<D>& particles, const Snapshot& end, const Lines& order, const std::string& whose) {
  require_count(end, order.size(), std::vector<bool>(order.size(), true));
  if (end.x.empty())
    fail_output("{} has displacements alone, which do not say which particle is which (write id, X or x)", end.file);
  const std::size_t others = strayed(particles, end, order);
  if (others == 0) return order;
  if (Lines nearest = by_nearest(particles, particles.x0, end); !nearest.empty()) return nearest;
  fail_output(
      "the order of {} cannot be verified: in that of {}, {} of {} particles are half a particle spacing or more from "
      "the exact solution (write id or X)",
      end.file, whose, others, order.size());
}

/// Whether most particles are where a neighbour along one of the axes could not be: the two are off their exact places
/// by vectors that differ by a spacing or more. Errors of a method, even large ones, are much the same for neighbours.
template <int D>
bool is_torn(const CaseParticles<D>& particles, const Snapshot& end, const Lines& lines) {
  std::vector<Vec<D>> off(particles.size());
  for (std::size_t line = 0; line < lines.size(); ++line)
    off[lines[line]] = vec<D>(end.x[line]) - particles.exact(lines[line], particles.end_time);
  const NearestPoint<D> nearest(particles.X);
  const auto is_off = [&](std::size_t p, int axis) {
    const Neighbour next = nearest(particles.X[p] + particles.spacing * Vec<D>::Unit(axis));
    return next.distance < particles.spacing / 2 &&
           !(particles.difference(off[next.point], off[p]).norm() < particles.spacing);
  };
  std::size_t count = 0;
  for (std::size_t p = 0; p < off.size(); ++p) {
    bool is_any = false;
    for (int axis = 0; axis < D; ++axis) is_any = is_any || is_off(p, axis);
    if (is_any) ++count;
  }
  return 2 * count > off.size();
}

/// Requires that ids are those of the case: a state that fits the exact solution, or the start, particle by particle
/// must not do so only with other ids. One that fits neither has blown up, which is a result.
template <int D>
void require_ids_of_case(const CaseParticles<D>& particles, const Snapshot& end, const Lines& by_id) {
  if (end.x.empty() || 2 * strayed(particles, end, by_id) <= by_id.size() || !is_torn(particles, end, by_id)) return;
  std::vector<Vec<D>> exact;
  for (std::size_t p = 0; p < particles.size(); ++p) exact.push_back(particles.exact(p, particles.end_time));
  const Lines at_start = by_nearest(particles, particles.x0, end);
  if (at_start == by_id) return;  // a body that has not moved
  const Lines at_end = by_nearest(particles, exact, end), &found = at_end.empty() ? at_start : at_end;
  for (std::size_t line = 0; line < found.size(); ++line)
    if (found[line] != by_id[line])
      fail_output(
          "ids of {} are not those of `mpmvv particles`: particle {} is where {} should be (give --start, or "
          "start of the adapter, or write X)",
          end.file, by_id[line] + 1, found[line] + 1);
}

}  // namespace

void require_each_once(const Output& output, std::size_t particles) {
  const bool has_case_ids = !output.start && !output.end.id.empty() && !has_reference_places(output.end);
  if (has_case_ids) by_case_id(output.end, particles);
  for (const Snapshot* s : {output.start ? &*output.start : nullptr, &output.end}) {
    if (!s) continue;
    if (!has_reference_places(output.end)) require_distinct_ids(*s);
    require_count(*s, particles, std::vector<bool>(particles, true));
  }
}

template <int D>
Lines match(const CaseParticles<D>& particles, const Output& output) {
  const Snapshot& end = output.end;
  if (const auto X = reference_places(particles, end); !X.empty()) return by_place(particles, X, particles.X, end);
  if (!output.start) {
    if (!end.id.empty()) {
      const Lines by_id = by_case_id(end, particles.size());
      require_ids_of_case(particles, end, by_id);
      return by_id;
    }
    Lines order(particles.size());
    std::iota(order.begin(), order.end(), 0U);
    return by_order(particles, end, order, "the case's particles");
  }
  const Lines start = of_start(particles, *output.start);
  if (!end.id.empty() && !output.start->id.empty()) return by_start_id(end, *output.start, start);
  return by_order(particles, end, start, output.start->file);
}

template Lines match<1>(const CaseParticles<1>&, const Output&);
template Lines match<2>(const CaseParticles<2>&, const Output&);
template Lines match<3>(const CaseParticles<3>&, const Output&);

}  // namespace mpmvv::codes
