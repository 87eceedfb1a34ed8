#include "studies/runs/prepared_case.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "solver/words.hpp"
#include "studies/runs/fill.hpp"
#include "studies/runs/for_solver.hpp"
#include "studies/runs/without_images.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/named.hpp"

namespace mpmvv::runs {

using cases::Case;

namespace {

using solver::Vec;

/// Fills the body: sets the reference positions, the volumes, and the widths that the basis takes. Returns which voxels
/// of the fill are kept.
template <int D>
WithoutImages<D> fill(PreparedCase<D>& prepared, const Case& c) {
  auto& scene = prepared.scene;
  const auto width = width_of(scene.basis);
  const auto about = static_cast<std::size_t>(
      std::lround(problems::extent(c).cells_of_body * std::pow(c.resolution.ppc, D) / count(scene.images)));
  prepared.X.reserve(about);
  scene.particles.V0.reserve(about);
  WithoutImages<D> kept(scene.images, scene.h);
  const PlaceVoxel<D> place = [&](const Voxel<D>& voxel) {
    const int particles = kept.take(voxel);
    if (particles == 0) return;
    if (scene.images != solver::Images::none) prepared.with_images.push_back(static_cast<std::uint8_t>(particles));
    prepared.X.push_back(voxel.X);
    scene.particles.V0.push_back(kept.share(particles) * voxel.V);
    if (width == solver::ParticleWidth::domain)
      scene.particles.R.push_back(voxel.edges / scene.h);
    else if (width != solver::ParticleWidth::none)
      scene.particles.l.push_back(Vec<D>::Constant(std::pow(voxel.V, 1.0 / D) / scene.h));
  };
  const FillDensity density{scene.h, c.resolution.ppc};
  switch (c.scheme.fill) {
    case cases::Fill::lattice:
      fill_lattice<D>(prepared.setup.body, density, place);
      break;
    case cases::Fill::conforming:
      if constexpr (D > 1) fill_conforming<D>(std::get<problems::Annulus<D>>(prepared.setup.body), density, place);
  }
  return kept;
}

/// Sets position, velocity, deformation gradient and mass at t = 0. With start `exact` it takes the velocity of -Δt/2,
/// W §4.
template <int D>
void set_initial_state(PreparedCase<D>& prepared, const Case& c) {
  auto& particles = prepared.scene.particles;
  const double velocity_time = c.scheme.start == cases::Start::exact ? -c.resolution.dt / 2 : 0;
  particles.resize(prepared.X.size());
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<D>& X = prepared.X[p];
    const auto& solution = prepared.setup.solution;
    particles.x[p] = solution ? Vec<D>(X + solution->u(X, 0)) : X;
    particles.v[p] = solution ? solution->v(X, velocity_time) : prepared.setup.start_velocity(X);
    particles.F[p] = solution ? solution->F(X, 0) : solver::Mat<D>::Identity();
    particles.m[p] = prepared.setup.density * particles.V0[p];
  }
}

/// Stores the reference widths and edges, and sets those that follow the deformation of the particles.
template <int D>
void set_current_widths(solver::Particles<D>& particles, const solver::AnyBasis& basis) {
  if (width_of(basis) == solver::ParticleWidth::current) particles.l0 = particles.l;
  particles.R0 = particles.R;
  particles.update_widths(0, particles.size());
}

/// Returns the velocity update with the order, interval and positions of the scheme, where it takes them. `cfl` is the
/// Courant number of a step.
solver::AnyVelocityUpdate velocity_update(const cases::Scheme& scheme, double cfl) {
  auto update = settings::named<solver::AnyVelocityUpdate>(scheme.velocity_update);
  const auto choose = [&](auto& u) {
    if constexpr (requires { u.order; }) u.order = scheme.order;
    if constexpr (requires { u.interval; })
      u.interval = std::max<std::int64_t>(1, std::llround(std::min(scheme.cfl_x / cfl, 1e15)));
    if constexpr (requires { u.position; }) u.position = for_solver(scheme.position);
  };
  std::visit(choose, update);
  return update;
}

/// Sets the boundaries of the faces, and for walls their motion, depth and gradient.
template <int D>
void set_boundaries(PreparedCase<D>& prepared, const cases::Scheme& scheme) {
  const auto faces = settings::boundary_faces(scheme.boundary, D, "the case");
  for (std::size_t k = 0; k < faces.size(); ++k) {
    auto& boundary = prepared.scene.boundary[k];
    solver::from_word(faces[k], boundary);
    if (auto* wall = std::get_if<solver::Wall>(&boundary)) {
      prepared.is_driven = true;
      wall->motion = prepared.setup.walls[k].get();
      wall->depth = scheme.wall_depth;
      wall->gradient = for_solver(scheme.wall_gradient);
    }
  }
}

/// Shuffles the particles by the method of Fisher and Yates, in the same way on every machine; seed 0 leaves their
/// order.
template <int D>
void shuffle(solver::Particles<D>& particles, int seed) {
  if (seed == 0) return;
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  solver::Array<std::uint32_t> order(particles.size());
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t left = order.size(); left > 1; --left) std::swap(order[left - 1], order[random() % left]);
  solver::ThreadPool alone(1);
  particles.permute(order, alone);
}

}  // namespace

template <int D>
problems::Domain<D> background_grid(const Case& c, const problems::Setup<D>& setup, double h) {
  auto grid = std::visit([h](const auto& body) { return problems::domain(body, h); }, setup.body);
  const auto faces = settings::boundary_faces(c.scheme.boundary, D, "the case");
  const auto movable = settings::movable_axes(faces);
  for (std::size_t d = 0; d < D; ++d) {
    if (c.resolution.grid_offset == 0 || !movable[d]) continue;
    grid.lower[static_cast<int>(d)] -= c.resolution.grid_offset * h;
    if (faces[2 * d] == solver::Free::word) ++grid.cells[d];
  }
  return grid;
}

template <int D>
PreparedCase<D> prepare_case(const Case& c, const problems::Problem& problem, int threads, solver::Images images) {
  PreparedCase<D> prepared;
  auto& scene = prepared.scene;
  scene.h = problem.length(c.problem.parameters) / c.resolution.cells;
  prepared.setup = problems::make_setup<D>(problem, c.problem, scene.h);
  const auto grid = background_grid<D>(c, prepared.setup, scene.h);
  scene.lower = grid.lower;
  scene.cells = grid.cells;
  problems::choose_law(prepared.setup, problem, c.scheme.material);
  scene.material = prepared.setup.material;
  scene.integrator = c.scheme.integrator;
  scene.velocity_update =
      velocity_update(c.scheme, problem.wave_speed(c.problem.parameters) * c.resolution.dt / scene.h);
  scene.deformation = for_solver(c.scheme.deformation);
  if (c.scheme.wall_method != cases::WallMethod::none) scene.wall_method = for_solver(c.scheme.wall_method);
  scene.half_start = c.scheme.start == cases::Start::half && prepared.setup.solution;
  scene.difference_acceleration = c.scheme.wall_acceleration == cases::WallAcceleration::difference;
  if (c.scheme.mass == cases::Mass::consistent) scene.consistent_mass.emplace();
  scene.threads = threads;
  scene.images = prepared.images = images;
  set_boundaries(prepared, c.scheme);

  scene.basis = settings::named<solver::AnyBasis>(c.scheme.basis);
  if (auto* ugimp = std::get_if<solver::UGimp>(&scene.basis)) ugimp->smoothing_length = c.scheme.smoothing_length;
  const WithoutImages<D> kept = fill(prepared, c);
  set_initial_state(prepared, c);
  set_current_widths(scene.particles, scene.basis);
  if (prepared.setup.solution) {
    prepared.points = prepared.setup.solution->at_points(prepared.X);
    prepared.body_force = std::make_unique<SolutionBodyForce<D>>(*prepared.setup.solution, *prepared.points);
    scene.body_force = prepared.body_force.get();
    scene.body_force_on = for_solver(c.scheme.body_force);
    if (prepared.points->reads_places() && scene.body_force_on == solver::BodyForceOn::particles)
      scene.particles.X.assign(prepared.X.begin(), prepared.X.end());
    if (problem.is_loaded && problem.is_loaded(c.problem.parameters)) {
      prepared.traction = std::make_unique<SolutionTraction<D>>(
          *prepared.setup.solution, kept.patches(surface<D>(prepared.setup.body, {scene.h, c.resolution.ppc})),
          prepared.X);
      scene.surface_load = prepared.traction.get();
    }
  }
  shuffle(scene.particles, c.resolution.shuffle);
  return prepared;
}

template class SolutionBodyForce<1>;
template class SolutionBodyForce<2>;
template class SolutionBodyForce<3>;
template class SolutionTraction<1>;
template class SolutionTraction<2>;
template class SolutionTraction<3>;
template problems::Domain<1> background_grid<1>(const Case&, const problems::Setup<1>&, double);
template problems::Domain<2> background_grid<2>(const Case&, const problems::Setup<2>&, double);
template problems::Domain<3> background_grid<3>(const Case&, const problems::Setup<3>&, double);
template PreparedCase<1> prepare_case<1>(const Case&, const problems::Problem&, int, solver::Images);
template PreparedCase<2> prepare_case<2>(const Case&, const problems::Problem&, int, solver::Images);
template PreparedCase<3> prepare_case<3>(const Case&, const problems::Problem&, int, solver::Images);

}  // namespace mpmvv::runs
