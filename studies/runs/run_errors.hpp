#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/mpm.hpp"
#include "studies/runs/norms.hpp"
#include "studies/runs/particle_errors.hpp"
#include "studies/runs/prepared_case.hpp"

/// Errors of a run's particles against the exact solution.
namespace mpmvv::runs {

/// Returns x moved by whole periods to the smallest distance from 0.
inline double nearest_image(double x, double period) {
  return x - period * std::round(x / period);
}

/// Calls visit(p, δ_p) with δ_p = |(x_p - X_p) - u(X_p, t)| for every particle, W (64); across periodic faces δ_p is
/// that of the nearest image.
template <int D, class Visit>
void for_displacement_errors(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared, const Visit& visit) {
  constexpr std::size_t chunk = 256;
  const auto& particles = mpm.particles();
  const auto& grid = mpm.grid();
  const auto& periodic = mpm.periodic();
  solver::Vec<D> u[chunk];
  for (std::size_t begin = 0; begin < particles.size(); begin += chunk) {
    const std::size_t n = std::min(chunk, particles.size() - begin);
    prepared.points->displacement(mpm.time(), {&particles.id[begin], n}, u);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t p = begin + k;
      solver::Vec<D> delta = (particles.x[p] - prepared.X[particles.id[p]]) - u[k];
      for (int d = 0; d < D; ++d) {
        const double period = grid.h() * grid.cells()[static_cast<std::size_t>(d)];
        if (periodic[static_cast<std::size_t>(d)]) delta[d] = nearest_image(delta[d], period);
      }
      visit(p, delta.norm());
    }
  }
}

template <int D>
ErrorNorms displacement_errors(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared) {
  ErrorNorms norms;
  for_displacement_errors(
      mpm, prepared, [&](std::size_t p, double delta) { norms.add(delta, prepared.count_of(mpm.particles().id[p])); });
  return norms;
}

/// Returns the displacement errors with the places of the particles and of their images.
template <int D>
std::vector<records::ParticleError> particle_errors(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared,
                                                    int ppc) {
  const auto& particles = mpm.particles();
  ParticleErrors errors(D, mpm.grid().h() / ppc);
  for_displacement_errors(mpm, prepared, [&](std::size_t p, double delta) {
    solver::Vec<D> X = prepared.X[particles.id[p]], x = particles.x[p];
    for (int k = 0; k < prepared.count_of(particles.id[p]); ++k) {
      errors.add<D>(X, x, delta);
      X = next_image(prepared.images, X), x = next_image(prepared.images, x);
    }
  });
  return errors.reduced();
}

/// Returns the root mean square over the particles of `error(p, X_p)`.
template <int D, class Error>
double rms_over_particles(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared, const Error& error) {
  ErrorNorms norms;
  for (std::size_t p = 0; p < mpm.particles().size(); ++p) {
    const auto id = mpm.particles().id[p];
    norms.add(error(p, prepared.X[id]), prepared.count_of(id));
  }
  return norms.l2();
}

/// The mean, over the steps noted, of the RMS velocity error of the particles.
template <int D>
class VelocityError {
 public:
  void note(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared) {
    sum_ += rms_over_particles(mpm, prepared, [&](std::size_t p, const solver::Vec<D>& X) {
      return (mpm.particles().v[p] - prepared.setup.solution->v(X, mpm.time())).norm();
    });
    ++steps_;
  }
  double mean() const { return sum_ / static_cast<double>(steps_); }

 private:
  double sum_ = 0;
  std::int64_t steps_ = 0;
};

/// Returns the RMS over the particles of |σ_p - σ(X_p, t)|.
template <int D>
double stress_error(const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared) {
  return rms_over_particles(mpm, prepared, [&](std::size_t p, const solver::Vec<D>& X) {
    const solver::Mat<D> F = prepared.setup.solution->F(X, mpm.time()), P = prepared.setup.solution->P(X, mpm.time());
    return (mpm.stress(p) - P * F.transpose() / F.determinant()).norm();
  });
}

}  // namespace mpmvv::runs
