#include "studies/run/scene.hpp"

#include <cmath>

#include "studies/boundaries.hpp"

namespace mpmvv {

namespace {

using solver::Vec;

/// Centres of the n^D equal boxes of the domain, first axis fastest.
template <int D>
std::vector<Vec<D>> lattice(const Vec<D>& lower, double length, int n) {
  std::vector<Vec<D>> X(static_cast<std::size_t>(std::pow(n, D) + 0.5));
  for (std::size_t k = 0; k < X.size(); ++k) {
    std::size_t rest = k;
    for (int d = 0; d < D; ++d) {
      X[k][d] = lower[d] + length * (static_cast<double>(rest % static_cast<std::size_t>(n)) + 0.5) / n;
      rest /= static_cast<std::size_t>(n);
    }
  }
  return X;
}

/// Position, velocity and deformation gradient at t = 0; with start `exact` the velocity of -Δt/2, W §4.
template <int D>
void set_initial_state(Stage<D>& stage, const Case& c) {
  auto& particles = stage.scene.particles;
  const double velocity_time = c.scheme.start == "exact" ? -c.resolution.dt / 2 : 0;
  const double volume = std::pow(stage.scene.h / c.resolution.ppc, D);
  particles.resize(stage.X.size());
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<D>& X = stage.X[p];
    const auto& solution = stage.setup.solution;
    particles.x[p] = solution ? Vec<D>(X + solution->u(X, 0)) : X;
    particles.v[p] = solution ? solution->v(X, velocity_time) : stage.setup.start_velocity(X);
    particles.F[p] = solution ? solution->F(X, 0) : solver::Mat<D>::Identity();
    particles.V0[p] = volume;
    particles.m[p] = stage.setup.density * volume;
  }
}

/// The widths that the basis takes of the particles, and its smoothing length.
template <int D>
void set_basis(Stage<D>& stage, const Case& c) {
  auto& scene = stage.scene;
  auto& particles = scene.particles;
  solver::from_word(c.scheme.basis, scene.basis);
  if (auto* ugimp = std::get_if<solver::UGimp>(&scene.basis)) ugimp->smoothing_length = c.scheme.smoothing_length;
  const auto width = std::visit([]<class B>(const B&) { return B::width; }, scene.basis);
  if (width == solver::ParticleWidth::none) return;
  particles.l.assign(particles.size(), Vec<D>::Constant(1.0 / c.resolution.ppc));
  if (width == solver::ParticleWidth::reference) return;
  particles.l0 = particles.l;
  for (std::size_t p = 0; p < particles.size(); ++p)
    particles.l[p] = particles.l0[p].cwiseProduct(particles.F[p].diagonal());
}

}  // namespace

template <int D>
Stage<D> make_stage(const Case& c, const Problem& problem, int threads) {
  Stage<D> stage;
  stage.setup = std::get<SetupFunction<D>>(problem.setup)(c.problem.parameters);
  auto& scene = stage.scene;
  scene.lower = stage.setup.lower;
  scene.h = problem.length / c.resolution.cells;
  scene.cells.fill(c.resolution.cells);
  scene.material = stage.setup.material;
  scene.integrator = c.scheme.integrator;
  scene.half_start = c.scheme.start == "half" && stage.setup.solution;
  scene.difference_acceleration = c.scheme.wall_acceleration == "difference";
  if (c.scheme.mass == "consistent") scene.consistent_mass.emplace();
  scene.threads = threads;
  const auto faces = boundary_faces(c.scheme.boundary, D, "the case");
  for (std::size_t k = 0; k < faces.size(); ++k) solver::from_word(faces[k], scene.boundary[k]);

  stage.X = lattice<D>(scene.lower, problem.length, c.resolution.cells * c.resolution.ppc);
  set_initial_state(stage, c);
  set_basis(stage, c);
  if (stage.setup.solution) {
    stage.points = stage.setup.solution->at_points(stage.X);
    stage.body_force = std::make_unique<SolutionBodyForce<D>>(*stage.setup.solution, *stage.points);
    scene.body_force = stage.body_force.get();
    if (c.scheme.body_force == "grid") scene.body_force_on = solver::BodyForceOn::grid;
  }
  return stage;
}

template Stage<1> make_stage<1>(const Case&, const Problem&, int);
template Stage<2> make_stage<2>(const Case&, const Problem&, int);
template Stage<3> make_stage<3>(const Case&, const Problem&, int);

}  // namespace mpmvv
