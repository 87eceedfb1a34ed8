#include "studies/plan/estimates.hpp"

#include <cmath>

#include "solver/scene.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/traits.hpp"

namespace mpmvv::plan {

namespace {

/// Doubles that a field of so many components takes on a node.
int padded(int components) {
  return components == 3 ? solver::padded_size<3> : components;
}

/// Doubles on each node: momentum with mass, force, velocity, acceleration, and what solving for a mass matrix keeps.
int doubles_per_node(const cases::Scheme& scheme, int D) {
  const int grid = padded(D + 1) + 3 * padded(D);
  if (scheme.mass == cases::Mass::consistent) return grid + 3 + padded(D + 1) + 5 * padded(D);
  return grid + (scheme.order > 0 ? 2 * padded(D) : 0);
}

/// Doubles of each particle that solving for a mass matrix keeps: the nodes of the particle's domain.
double doubles_per_domain(const cases::Scheme& scheme, int D) {
  if (scheme.mass != cases::Mass::consistent && scheme.order < 3) return 0;
  return std::visit(
      [D]<class B>(const B&) {
        return B::width == solver::ParticleWidth::domain ? solver::power(B::support + 1, D) + 0.5 : 0.0;
      },
      settings::named<solver::AnyBasis>(scheme.basis));
}

/// Doubles of each particle: positions (with the reference ones), velocities, F, widths or edges, mass, volume,
/// identity, spatial parts of the body force, and what the scheme and the material keep beside.
double doubles_per_particle(const cases::Scheme& scheme, int D) {
  const bool has_domain = width_of(settings::named<solver::AnyBasis>(scheme.basis)) == solver::ParticleWidth::domain;
  const double widths = has_domain ? 2 * D * D : 2 * D;
  const solver::Integrator& integrator = solver::integrator_named(scheme.integrator);
  const double stages = integrator.is_staged ? 2 * (2 * D + D * D) : 0;
  const double rate = integrator.is_remapped ? D : 0;
  const auto update = settings::named<solver::AnyVelocityUpdate>(scheme.velocity_update);
  const auto material = settings::named<solver::AnyMaterial>(scheme.material);
  const double affine = has_affine_field(update) ? D * D : 0;
  const double history = settings::keeps_history(material) ? sizeof(solver::ThermalState) / 8.0 : 0;
  return 3 * D + 2 * D * D + widths + 4 + stages + rate + affine + history + doubles_per_domain(scheme, D);
}

/// Number of particles, about.
double particles(const cases::Case& c) {
  const int D = problems::find_problem(c.problem.name, "the case").dimension();
  return problems::extent(c).cells_of_body * std::pow(c.resolution.ppc, D);
}

}  // namespace

double work_estimate(const cases::Case& c) {
  const double expansion = c.scheme.order > 0 ? 1 + 0.2 * (c.scheme.order - 1) : 1;
  return expansion * particles(c) * static_cast<double>(c.resolution.steps);
}

double share_alone(const cases::Case& c) {
  return static_cast<double>(c.measure.repeat) / (1 + c.measure.repeat);
}

bool can_be_shared(const cases::Case& c, int images) {
  return c.scheme.code.empty() && particles(c) / images >= 3.0 * static_cast<double>(solver::Scene<1>().least_in_slab);
}

bool outlasts_others(double seconds, double all, int jobs) {
  constexpr double long_time = 5;
  return seconds > long_time && seconds * jobs > all;
}

double memory_estimate(const cases::Case& c, int images) {
  const int D = problems::find_problem(c.problem.name, "the case").dimension();
  const int beside = 1 + 2 * ghosts_of(settings::named<solver::AnyBasis>(c.scheme.basis));
  const double nodes = std::pow(std::pow(problems::extent(c).cells_of_domain, 1.0 / D) + beside, D);
  const double sorting = 8 * (1 + D + D * D) + 12;  // bytes: a number, a vector, a matrix, three indices
  return (8 * doubles_per_particle(c.scheme, D) + sorting) * particles(c) / images +
         8 * doubles_per_node(c.scheme, D) * nodes;
}

}  // namespace mpmvv::plan
