#include "solver/mpm.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "solver/integrator/integrators.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

template <int D>
Mpm<D>::Mpm(Scene<D> scene) : step_(std::make_unique<Step<D>>(std::move(scene))) {}

template <int D>
Mpm<D>::~Mpm() = default;

template <int D>
Mpm<D>::Mpm(Mpm&&) noexcept = default;

template <int D>
bool Mpm<D>::step(double dt) {
  advance(dt, 1);
  return step_->fault() == Fault::none;
}

template <int D>
std::int64_t Mpm<D>::advance(double dt, std::int64_t steps) {
  if (!(dt > 0 && std::isfinite(dt))) throw std::invalid_argument("a time step that is not above 0");
  return step_->advance(dt, steps);
}

template <int D>
bool Mpm<D>::check() {
  step_->check();
  return step_->fault() == Fault::none;
}

template <int D>
std::string Mpm<D>::fault() const {
  const Fault fault = step_->fault();
  if (contains(fault, Fault::outside)) return "a particle left the domain";
  if (contains(fault, Fault::outgrown))
    return width_of(step_->scene().basis) == ParticleWidth::domain
               ? "a corner of a particle is more than " + std::to_string(domain_reach) + " cells from it"
               : "the width of a particle is not between zero and a cell";
  if (contains(fault, Fault::inverted)) return "det F <= 0 on a particle";
  return "";
}

template <int D>
const Particles<D>& Mpm<D>::particles() const {
  return step_->particles();
}

template <int D>
const Grid<D>& Mpm<D>::grid() const {
  return step_->grid();
}

template <int D>
const std::array<bool, D>& Mpm<D>::periodic() const {
  return step_->periodic();
}

template <int D>
double Mpm<D>::time() const {
  return step_->time();
}

template <int D>
std::int64_t Mpm<D>::steps() const {
  return step_->steps();
}

template <int D>
double Mpm<D>::with_images(double sum) const {
  return count(step_->scene().images) * sum;
}

template <int D>
double Mpm<D>::mass() const {
  return with_images(std::accumulate(particles().m.begin(), particles().m.end(), 0.0));
}

template <int D>
Mat<D> Mpm<D>::stress(std::size_t p) const {
  return std::visit(
      [&]<class M>(const M& material) -> Mat<D> {
        if constexpr (has_history<M>)
          return -thermal_state(p).total_pressure() * Mat<D>::Identity();
        else
          return material.kirchhoff(particles().F[p]) / particles().F[p].determinant();
      },
      step_->scene().material);
}

template <int D>
ThermalState Mpm<D>::thermal_state(std::size_t p) const {
  return std::visit(
      [&]<class M>(const M& material) -> ThermalState {
        if constexpr (has_history<M>) {
          ThermalState state = particles().thermal[p];
          const StressStep since{step_->integrator().share_after_stress * step_->dt(), grid().h()};
          if (since.dt > 0) material.kirchhoff(particles().F[p], state, since);  // which advances the state
          return state;
        } else {
          throw std::invalid_argument("the thermal state of a material without a history");
        }
      },
      step_->scene().material);
}

template <int D>
double Mpm<D>::kinetic_energy() const {
  double energy = 0;
  for (std::size_t p = 0; p < particles().size(); ++p)
    energy += 0.5 * particles().m[p] * particles().v[p].squaredNorm();
  return with_images(energy);
}

template <int D>
double Mpm<D>::strain_energy() const {
  return with_images(std::visit(
      [&, &all = particles()]<class M>(const M& material) {
        double energy = 0;
        for (std::size_t p = 0; p < all.size(); ++p)
          if constexpr (has_history<M>)
            energy += all.m[p] * thermal_state(p).energy;
          else
            energy += all.V0[p] * material.template energy<D>(all.F[p]);
        return energy;
      },
      step_->scene().material));
}

template <int D>
void Mpm<D>::map_acceleration() {
  if (!particles().thermal.empty())
    throw std::invalid_argument("accelerations of a material with a history, outside of a step");
  step_->map_momentum_and_forces();
  step_->set_acceleration();
  if (step_->scene().half_start && step_->steps() == 0)  // a step would want the half
    for (auto& a : step_->grid().a) a *= 2;
}

template <int D>
Vec<D> Mpm<D>::node_position(std::size_t n) const {
  return step_->node_position(n);
}

template <int D>
bool Mpm<D>::is_accelerated(std::size_t n) const {
  return step_->is_accelerated(n);
}

template class Mpm<1>;
template class Mpm<2>;
template class Mpm<3>;

}  // namespace mpmvv::solver
