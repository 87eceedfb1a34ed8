#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/mpm.hpp"
#include "studies/cases/case.hpp"
#include "studies/problems/setup.hpp"
#include "studies/runs/fill.hpp"

namespace mpmvv::runs {

/// Gives the solver the body force of the manufactured solution.
template <int D>
class SolutionBodyForce final : public solver::BodyForce<D> {
 public:
  SolutionBodyForce(const mms::ManufacturedSolution<D>& solution, mms::PointwiseSolution<D>& points)
      : solution_(solution), points_(points) {}

  void prepare(double t) override { points_.prepare(t); }
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const solver::Vec<D>> X,
                    solver::Vec<D>* b) const override {
    points_.body_force(t, ids, X, b);
  }
  solver::Vec<D> at_position(const solver::Vec<D>& x, double t) const override {
    return solution_.b(solution_.reference_point(x, t), t);
  }

 private:
  const mms::ManufacturedSolution<D>& solution_;
  mms::PointwiseSolution<D>& points_;
};

/// Gives the solver the traction of the manufactured solution on the surface of the body.
template <int D>
class SolutionTraction final : public solver::SurfaceLoad<D> {
 public:
  using typename solver::SurfaceLoad<D>::Part;

  SolutionTraction(const mms::ManufacturedSolution<D>& solution, std::vector<SurfacePatch<D>> patches,
                   const std::vector<solver::Vec<D>>& X)
      : solution_(solution), patches_(std::move(patches)) {
    for (const auto& patch : patches_) parts_.push_back({patch.voxel, patch.X - X[patch.voxel]});
  }

  std::span<const Part> parts() const override { return parts_; }
  void forces(double t, solver::Vec<D>* f) const override {
    for (const auto& patch : patches_) *f++ = solution_.P(patch.X, t) * patch.normal;  // P N dA
  }

 private:
  const mms::ManufacturedSolution<D>& solution_;
  std::vector<SurfacePatch<D>> patches_;
  std::vector<Part> parts_;
};

// Compiled once, with the options of the runs, whatever the options of the files that include this one.
extern template class SolutionBodyForce<1>;
extern template class SolutionBodyForce<2>;
extern template class SolutionBodyForce<3>;
extern template class SolutionTraction<1>;
extern template class SolutionTraction<2>;
extern template class SolutionTraction<3>;

/// A case ready to run: the solution of the problem sampled at the particles, and the scene made from it.
template <int D>
struct PreparedCase {
  problems::Setup<D> setup;
  std::vector<solver::Vec<D>> X;  ///< reference positions by particle id
  solver::Images images = solver::Images::none;
  bool is_driven = false;  ///< whether the case has moving walls: they put energy in, so that the energy has no bound
  std::vector<std::uint8_t> with_images;  ///< `count_of` of each particle, by id; empty where it is one for all
  std::unique_ptr<mms::PointwiseSolution<D>> points;
  std::unique_ptr<SolutionBodyForce<D>> body_force;
  std::unique_ptr<SolutionTraction<D>> traction;  ///< null where the surface is free or held
  solver::Scene<D> scene;

  /// Returns how many particles of the body a particle stands for, itself and its images.
  int count_of(std::uint32_t id) const { return with_images.empty() ? 1 : with_images[id]; }
};

/// Returns the mass of the body: ρ₀ times its volume.
template <int D>
double mass_of(const problems::Setup<D>& setup) {
  return setup.density * std::visit([](const auto& body) { return problems::volume(body); }, setup.body);
}

/// Returns the background grid, which surrounds the body. Along each axis that no face holds, it is moved down by the
/// grid offset of the case. Between free faces it then has a cell more, so that it still covers the body.
template <int D>
problems::Domain<D> background_grid(const cases::Case& c, const problems::Setup<D>& setup, double h);

/// Makes a case ready to run: fills the body with particles in their state at t = 0, without those that are images of
/// others.
template <int D>
PreparedCase<D> prepare_case(const cases::Case& c, const problems::Problem& problem, int threads,
                             solver::Images images = solver::Images::none);

extern template problems::Domain<1> background_grid<1>(const cases::Case&, const problems::Setup<1>&, double);
extern template problems::Domain<2> background_grid<2>(const cases::Case&, const problems::Setup<2>&, double);
extern template problems::Domain<3> background_grid<3>(const cases::Case&, const problems::Setup<3>&, double);
extern template PreparedCase<1> prepare_case<1>(const cases::Case&, const problems::Problem&, int, solver::Images);
extern template PreparedCase<2> prepare_case<2>(const cases::Case&, const problems::Problem&, int, solver::Images);
extern template PreparedCase<3> prepare_case<3>(const cases::Case&, const problems::Problem&, int, solver::Images);

}  // namespace mpmvv::runs
