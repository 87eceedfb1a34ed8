#include "studies/settings/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "solver/boundary/boundaries.hpp"
#include "solver/velocity_update/affine.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/traits.hpp"
#include "studies/support/error.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::settings {

using cases::Case;
using cases::Mass;
using cases::Scheme;
using cases::WallAcceleration;
using problems::Problem;

namespace {

/// Whether nodes lie a cell apart and a particle has weights on several of them, wherever it is.
bool is_affine(const solver::AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return solver::has_affine_fields<B>; }, basis);
}

/// Whether the update takes velocities of the consistent mass matrix and adds no accelerations.
bool takes_consistent_velocity(const solver::AnyVelocityUpdate& update) {
  return takes_consistent_mass(update) && !adds_accelerations(update);
}

/// A case, with the properties that the rules ask for.
struct Asked {
  const Case& c;
  const Problem& problem;
  const Scheme& s = c.scheme;
  const problems::Parameters& parameters = c.problem.parameters;
  std::vector<std::string> faces = boundary_faces(s.boundary, problem.dimension(), "the case");
  solver::AnyBasis basis = named<solver::AnyBasis>(s.basis);
  solver::AnyVelocityUpdate update = named<solver::AnyVelocityUpdate>(s.velocity_update);
  solver::AnyMaterial material = named<solver::AnyMaterial>(s.material);
  const solver::Integrator& integrator = solver::integrator_named(s.integrator);
  int ghosts = ghosts_of(basis);
  bool has_whole_steps = integrator.has_whole_steps();
  bool is_consistent = s.mass == Mass::consistent;
  bool takes_difference = s.wall_acceleration == WallAcceleration::difference;
  bool is_curved = problem.is_curved(parameters);
  bool is_loaded = problem.is_loaded && problem.is_loaded(parameters);
  bool has_solution = problem.has_solution(parameters);

  template <class Boundary>
  bool has() const {
    return std::ranges::find(faces, Boundary::word) != faces.end();
  }

  bool is_periodic_on_one_face() const {
    for (std::size_t k = 0; k < faces.size(); k += 2)
      if ((faces[k] == solver::Periodic::word) != (faces[k + 1] == solver::Periodic::word)) return true;
    return false;
  }

  /// Returns a face with `wall` for which the problem has no wall motion; empty when there is none.
  std::string wall_at_rest() const {
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (faces[k] == solver::Wall::word && !problem.has_wall(parameters, k)) return face_name(k);
    return "";
  }

  /// Returns the faces for which the problem has a wall motion, for messages.
  std::string walls() const {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (problem.has_wall(parameters, k)) names.push_back(face_name(k));
    return support::listed(names);
  }

  static std::string face_name(std::size_t k) { return fmt::format("{}{}", "xyz"[k / 2], k % 2 == 0 ? "min" : "max"); }

  /// Returns a face where a quarter was cut and whose boundary does not stand for the rest of the body, for example
  /// because it also holds tangential velocities; empty when there is none.
  std::string open_cut() const {
    const std::size_t side = problem.symmetry_planes == problems::SymmetryPlanes::at_lower_faces ? 0 : 1;
    for (std::size_t k = side; c.problem.quarter && k < faces.size(); k += 2)
      if (faces[k] != solver::Symmetry::word && faces[k] != solver::Mirror::word) return face_name(k);
    return "";
  }

  /// Returns the least distance between the problem's walls in cells during the run; 0 for a case without walls. The
  /// case may have only one of the two.
  double cells_between_walls() const {
    const auto wall = std::ranges::find(faces, solver::Wall::word);
    if (wall == faces.end()) return 0;
    return problems::least_cells_between_walls(c, static_cast<std::size_t>(wall - faces.begin()) / 2);
  }
  bool do_walls_hold_all() const {
    return s.wall_depth * static_cast<double>(std::ranges::count(faces, solver::Wall::word)) >= cells_between_walls();
  }

  /// Returns the number of cells between two faces: of a quarter along its shortest axis, of a whole body along L.
  int cells_across() const {
    return c.problem.quarter ? std::ranges::min(problems::domain_cells(c)) : c.resolution.cells;
  }

  bool has_width_of_a_particle() const {
    const auto width = width_of(basis);
    return width == solver::ParticleWidth::reference || width == solver::ParticleWidth::current;
  }

  int least_cells() const { return std::max(4, 2 * ghosts); }
};

/// What a case must not be, and the message where it is: {names} in it stand for values of the case, see `text_of`.
struct Rule {
  bool (*is_broken)(const Asked&);
  const char* message;
};

constexpr Rule rules[]{
    {[](const Asked& a) { return a.ghosts == 0 && (a.has<solver::Periodic>() || a.has<solver::Mirror>()); },
     "basis '{basis}' has no ghost nodes, so boundary '{boundary}' has nothing to act on (use dirichlet, symmetry or "
     "free, or a basis without '-open')"},
    {[](const Asked& a) { return a.is_periodic_on_one_face(); },
     "boundary '{boundary}' is periodic on one face only (both faces of an axis, or neither)"},

    {[](const Asked& a) { return a.has<solver::Wall>() && a.takes_difference; },
     "wall_acceleration 'difference' with boundary 'wall', whose nodes have it anyway (leave it out)"},
    {[](const Asked& a) { return a.takes_difference && !a.has<solver::Dirichlet>() && !a.has<solver::Symmetry>(); },
     "wall_acceleration 'difference' with boundary '{boundary}' that holds no node (use it with dirichlet or "
     "symmetry)"},
    {[](const Asked& a) { return a.takes_difference && a.integrator.is_accelerated_first; },
     "wall_acceleration 'difference' with integrator '{integrator}', which maps the velocity after the acceleration "
     "(use zero, or another integrator)"},
    {[](const Asked& a) { return a.takes_difference && a.integrator.is_staged; },
     "wall_acceleration 'difference' with integrator '{integrator}', whose stages have rates and no step to take a "
     "difference over (use zero, or another integrator)"},

    {[](const Asked& a) { return a.is_consistent && a.takes_difference; },
     "wall_acceleration 'difference' with mass 'consistent', whose velocities are solved for with the walls held: "
     "there is none of theirs to take a difference from (use zero)"},
    {[](const Asked& a) { return a.is_consistent && a.s.body_force == cases::BodyForce::grid; },
     "body_force 'grid' with mass 'consistent', which m_i b(x_i) lumps again (use particles)"},
    {[](const Asked& a) { return a.is_consistent && a.has<solver::Mirror>() && a.cells_across() <= 2 * a.ghosts; },
     "{cells_across} cells are too few for mass 'consistent' between mirrors (more than {twice_ghosts}: no node may be "
     "the image of two ghosts)"},
    {[](const Asked& a) { return a.is_consistent && a.c.resolution.ppc < 2; },
     "mass 'consistent' with ppc = 1 (at least 2: it is singular with one particle per cell)"},

    {[](const Asked& a) {
       return a.s.wall_method == cases::WallMethod::velocity && !expands_grid_velocity(a.update, 0);
     },
     "wall_method 'velocity' with velocity_update '{velocity_update}', which expands no grid velocity: walls "
     "hold those anyway (use combined, which is the same)"},
    {[](const Asked& a) { return !a.has_whole_steps && a.s.position != cases::Position::first_order; },
     "velocity_update '{velocity_update}' with integrator '{integrator}' ({placed_updates} with position "
     "'first-order', or an integrator whose steps have positions and velocities at their ends: {whole_integrators})"},
    {[](const Asked& a) { return has_affine_field(a.update) && !is_affine(a.basis); },
     "velocity_update '{velocity_update}' with basis '{basis}' ({affine_bases}: nodes a cell apart, whose weights "
     "spread wherever the particle is)"},
    {[](const Asked& a) { return a.is_consistent && !takes_consistent_mass(a.update); },
     "mass 'consistent' with velocity_update '{velocity_update}', which lumped masses define (use "
     "{consistent_updates})"},
    {[](const Asked& a) {
       return a.is_consistent && (a.s.order > 0 || a.s.cfl_x > 0 || a.s.wall_method != cases::WallMethod::none);
     },
     "order, cfl_x or wall_method with mass 'consistent', the limit in which nothing is expanded (leave it out)"},
    {[](const Asked& a) { return a.takes_difference && !adds_accelerations(a.update); },
     "wall_acceleration 'difference' with a velocity_update other than {adding_updates} (use zero)"},

    {[](const Asked& a) { return a.integrator.is_staged && a.s.deformation == cases::Deformation::exponential; },
     "deformation 'exponential' with integrator '{integrator}', whose stages are linear (use linear)"},
    {[](const Asked& a) { return a.integrator.is_staged && keeps_history(a.material); },
     "material '{material}' with integrator '{integrator}', whose stages go back in time (use another: its history "
     "goes forward)"},

    {[](const Asked& a) { return !a.wall_at_rest().empty(); },
     "boundary 'wall' on face {wall_at_rest} of problem '{problem}', which has no moving wall there (faces with "
     "one: {walls})"},
    {[](const Asked& a) { return a.has<solver::Wall>() && a.do_walls_hold_all(); },
     "wall_depth {wall_depth} of each wall, {cells_between_walls:.3g} cells apart (less: walls that hold all "
     "cells leave none to the method)"},
    {[](const Asked& a) { return a.has<solver::Wall>() && !a.has_whole_steps; },
     "boundary 'wall' with integrator '{integrator}' (one whose steps have positions and velocities at their ends: "
     "{whole_integrators})"},
    {[](const Asked& a) { return a.has<solver::Wall>() && a.is_consistent && adds_accelerations(a.update); },
     "boundary 'wall' with mass 'consistent' and velocity_update '{velocity_update}' (use {wall_updates}: it takes "
     "velocities, where accelerations at walls are a difference of lumped ones)"},

    {[](const Asked& a) {
       return a.c.resolution.grid_offset > 0 && std::ranges::none_of(movable_axes(a.faces), std::identity{});
     },
     "grid_offset with boundary '{boundary}', whose faces have their place among the nodes (periodic or free on both "
     "faces of an axis)"},
    {[](const Asked& a) { return !a.open_cut().empty(); },
     "boundary '{boundary}' of a quarter of problem '{problem}', whose face {open_cut} was cut (symmetry or mirror "
     "there)"},
    {[](const Asked& a) { return ends_between_nodes(a.c); },
     "quarter of problem '{problem}' on {cells} cells, whose planes of symmetry lie between nodes (an even number)"},
    {[](const Asked& a) {
       return (a.has<solver::Symmetry>() || a.has<solver::Mirror>()) && a.cells_across() < a.least_cells();
     },
     "{cells_across} cells are too few for boundary '{boundary}' (at least {least_cells}: ghosts and their images must "
     "differ)"},
    {[](const Asked& a) { return a.has_width_of_a_particle() && a.c.resolution.ppc < 2; },
     "basis '{basis}' with ppc = 1 (at least 2: a particle's width must stay below the cell's)"},

    {[](const Asked& a) { return a.s.fill == cases::Fill::conforming && !a.is_curved; },
     "fill 'conforming' has no meaning for problem '{problem}', which a lattice fills (use lattice)"},
    {[](const Asked& a) { return a.s.fill == cases::Fill::lattice && a.is_curved && a.is_loaded; },
     "fill 'lattice' for problem '{problem}' with a traction on its surface, which stairs do not have (use "
     "conforming)"},
    {[](const Asked& a) { return a.problem.is_one_particle && (a.c.resolution.cells != 1 || a.c.resolution.ppc != 1); },
     "problem '{problem}' with other cells or ppc (cells = 1 and ppc = 1)"},
    {[](const Asked& a) { return a.s.start == cases::Start::exact && !a.has_solution; },
     "problem '{problem}' has no exact velocity for start 'exact' (use start 'half')"},

    {[](const Asked& a) { return a.c.measure.every_step && !a.has_solution; },
     "problem '{problem}' has no exact displacement for every_step (leave it out)"},
    {[](const Asked& a) { return a.c.measure.nodal_error && !a.has_solution; },
     "problem '{problem}' has no exact acceleration for nodal_error (leave it out)"},
    {[](const Asked& a) { return a.c.measure.velocity_error && !a.problem.has_speed(a.parameters); },
     "problem '{problem}' has no speed that velocity_error is measured by (leave it out)"},
    {[](const Asked& a) { return a.c.measure.stress_error && !a.has_solution; },
     "problem '{problem}' has no exact stress for stress_error (leave it out)"},
    {[](const Asked& a) { return a.c.measure.particle_errors && !a.has_solution; },
     "problem '{problem}' has no exact displacement for particle_errors (leave it out)"},
    {[](const Asked& a) {
       return (a.c.measure.nodal_error || a.c.measure.stress_error) && a.s.material != a.problem.material;
     },
     "nodal_error or stress_error with material '{material}', of which the solution of problem '{problem}' is not "
     "exact (leave it out)"},
    {[](const Asked& a) { return a.c.measure.nodal_error && a.takes_difference; },
     "nodal_error with wall_acceleration 'difference', which belongs to a step and not to the end time (use zero)"},
    {[](const Asked& a) { return a.c.measure.nodal_error && a.s.wall_method == cases::WallMethod::velocity; },
     "nodal_error with wall_method 'velocity', which holds expanded velocities and no accelerations (use lumped, "
     "combined or elimination)"},
    {[](const Asked& a) { return a.c.measure.nodal_error && a.has<solver::Wall>(); },
     "nodal_error with boundary 'wall', whose acceleration belongs to a step and not to the end time (leave it out)"},
    {[](const Asked& a) { return !(a.c.measure.blowup_error > 0) || !(a.c.measure.blowup_energy > 0); },
     "blowup_error = {blowup_error} and blowup_energy = {blowup_energy} (both > 0)"},
};

/// Returns the velocity updates that have a property, as in "flip or fmpm".
template <class Property>
std::string updates(const Property& property) {
  return fmt::format("{}", fmt::join(words_with<solver::AnyVelocityUpdate>(property), " or "));
}

std::string text_of(const Rule& rule, const Asked& a) {
  using fmt::arg;
  return fmt::format(fmt::runtime(rule.message), arg("basis", a.s.basis), arg("integrator", a.s.integrator),
                     arg("velocity_update", a.s.velocity_update), arg("boundary", a.s.boundary),
                     arg("material", a.s.material), arg("problem", a.problem.name), arg("cells", a.c.resolution.cells),
                     arg("cells_across", a.cells_across()), arg("least_cells", a.least_cells()),
                     arg("twice_ghosts", 2 * a.ghosts), arg("wall_at_rest", a.wall_at_rest()), arg("walls", a.walls()),
                     arg("blowup_error", a.c.measure.blowup_error), arg("blowup_energy", a.c.measure.blowup_energy),
                     arg("wall_depth", a.s.wall_depth), arg("cells_between_walls", a.cells_between_walls()),
                     arg("open_cut", a.open_cut()), arg("placed_updates", updates(takes_position)),
                     arg("consistent_updates", updates(solver::takes_consistent_mass)),
                     arg("adding_updates", updates(solver::adds_accelerations)),
                     arg("wall_updates", updates(takes_consistent_velocity)),
                     arg("affine_bases", fmt::join(words_with<solver::AnyBasis>(is_affine), ", ")),
                     arg("whole_integrators", fmt::join(integrators_with(&solver::Integrator::has_whole_steps), ", ")));
}

}  // namespace

bool ends_between_nodes(const Case& c) {
  Case whole = c;
  whole.problem.quarter = false;
  return c.problem.quarter &&
         !std::ranges::all_of(problems::domain_cells(whole), [](int cells) { return cells % 2 == 0; });
}

bool is_valid(const Case& c, const Problem& problem) {
  const Asked asked{c, problem};
  return std::ranges::none_of(rules, [&](const Rule& rule) { return rule.is_broken(asked); });
}

void validate(const Case& c, const Problem& problem) {
  const Asked asked{c, problem};
  for (const Rule& rule : rules)
    if (rule.is_broken(asked)) throw support::UsageError(text_of(rule, asked));
}

std::vector<std::string> objections(const Case& c, const Problem& problem) {
  const Asked asked{c, problem};
  std::vector<std::string> texts;
  for (const Rule& rule : rules) texts.push_back(text_of(rule, asked));
  return texts;
}

}  // namespace mpmvv::settings
