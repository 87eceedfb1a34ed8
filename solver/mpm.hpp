#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/active_nodes.hpp"
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/scene.hpp"
#include "solver/slabs.hpp"
#include "solver/team.hpp"

namespace mpmvv::solver {

template <int D>
class ConsistentMass;
template <int D>
class ExpandedInverse;

/// The Material Point Method: owns particles and grid, advances them step by step. Members below "for integrators"
/// are the phases that an integrator's page puts in order.
template <int D>
class Mpm {
 public:
  /// Throws std::invalid_argument on what makes no scene: an unknown integrator, no particles or threads, particles
  /// without the widths that the basis takes, a wall without a motion.
  explicit Mpm(Scene<D> scene);
  ~Mpm();

  /// Advances by dt. False when the run has blown up: `fault` then says why and the state is of no use.
  bool step(double dt);

  const Particles<D>& particles() const { return particles_; }
  const Grid<D>& grid() const { return grid_; }
  const AnyBasis& basis() const { return scene_.basis; }
  const std::array<bool, D>& periodic() const { return periodic_; }
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }  ///< finished ones
  std::int64_t moves() const { return moves_; }  ///< how often particles have moved or been sorted
  std::string fault() const;
  double mass() const;                 ///< Σ m_p
  Mat<D> stress(std::size_t p) const;  ///< Cauchy stress of a particle
  double kinetic_energy() const;       ///< Σ m_p v_p²/2
  double strain_energy() const;        ///< Σ V⁰_p W(F_p), or the internal energy of a material with a history

  /// Maps the particles as they are now: the grid then holds m_i and a_i = f_i/m_i, constrained, of this very time,
  /// where a step leaves those of its start.
  void map_acceleration();
  Vec<D> node_position(std::size_t n) const;  ///< of the node at a storage index
  bool is_accelerated(std::size_t n) const { return grid_.m(n) > least_mass_; }

  // For integrators. Sweeps are defined in solver/mpm_sweeps.hpp, `clear` and `fold` in solver/mpm_grid.hpp.
  Particles<D>& particles() { return particles_; }
  Grid<D>& grid() { return grid_; }
  void set_time(double t) { time_ = t; }  ///< of the body force, for stages within a step
  void sort_strays();                     ///< to be called when positions have changed and the step goes on

  /// F by a time step of its own.
  DeformationStep<D> deformation_step(double dt) const { return {dt, scene_.deformation}; }

  /// One sweep over all particles with these stages.
  template <Adds adds = Adds::to_nodes, class... Stages>
  void sweep(const Stages&... stages);

  /// Calls visit(begin, end) for the particles of every slab; where slabs share nodes they take turns.
  template <class Visit>
  void for_slabs(const Visit& visit) {
    solver::for_slabs(Adds::to_nodes, slabs_, team_, [&](int slab) {
      const auto [begin, end] = slabs_.particles(slab);
      visit(begin, end);
    });
  }

  /// Calls visit(n) for every node with mass. Those without have no velocity and acceleration but what boundaries hold.
  template <class Visit>
  void for_nodes(const Visit& visit) {
    active_nodes_.visit(team_, visit);
  }

  /// One sweep of `before` and then of stress and forces: f_i, and whatever else `map` scatters with it.
  template <class Before, class... Map>
  void sweep_with_forces(const Before& before, const Map&... map);

  /// Sets a field to zero, before a scatter.
  template <class V>
  void clear(std::vector<V>& field);
  void clear_grid();  ///< masses, momenta and forces

  /// Adds up what the boundaries identify, after a scatter.
  template <class V>
  void fold(std::vector<V>& field);
  void fold_momentum();  ///< likewise after one of masses, which decides what `for_nodes` visits from then on
  void constrain(std::vector<Packed<D>>& field);             ///< v = C v, where walls stand still
  void constrain_transposed(std::vector<Packed<D>>& field);  ///< f = Cᵀ f

  // With the consistent mass, M̂⁻¹ takes the place of 1/m_i.
  void set_grid_velocity();               ///< v_i = p_i / m_i, constrained          S (2), W (9)
  void set_grid_acceleration();           ///< a_i = f_i / m_i, constrained if zero  S (5), W (15)
  void advance_grid_velocity(double dt);  ///< v_i += a_i Δt, constrained            S (6), W (16), S (30)

  /// Velocities by the expanded inverse from lumped ones, as the wall method has it; with the consistent mass they are
  /// right as they are.
  void expand_inverse(int order, std::vector<Packed<D>>& velocity);
  /// Makes the velocities that come of it obey the faces, unless the wall method leaves them.
  void hold_expanded(std::vector<Packed<D>>& velocity);

  void set_stress_velocity();  ///< v_i = p_i / m_i as the stress updates take it: by the expanded inverse for `fmpm`

  /// The middle of usf and usavg: F by the mapped velocity, the forces with it, and the grid velocity of the step's
  /// end.
  void update_stress_first(double dt_stress, double dt);

  /// What the velocity update makes of the grid's fields.
  VelocityFields<D> velocity_fields(double dt);

  /// The end of a step: positions and velocities by the velocity update, F by a time step of its own. FLIP with
  /// positions of first order, whose operations take v⁺ and a as they are, has a sweep of its own: it gathers no
  /// gradient that nothing asks for.
  void update_particles(double dt, double dt_deformation);

  /// The last sweep of a step: these gathers, then what must hold and be ready for the next step.
  template <class... Ops>
  void sweep_and_settle(const Ops&... ops);

 private:
  /// quotient = field / m_i where a node's mass exceeds `least_mass`, else zero.
  template <class V>
  void divide_by_mass(const std::vector<V>& field, double least_mass, std::vector<Packed<D>>& quotient);
  void set_wall_acceleration(double dt);
  /// Whether walls hold lumped velocities and accelerations: always, but for those that `fmpm` expands first.
  bool holds_lumped() const;
  void hold(std::vector<Packed<D>>& velocity);  ///< makes velocities obey the faces, moving walls among them
  void add_walls();
  void add_grid_body_force();
  void add_surface_load();
  void sort();
  void note(Fault fault) {
    if (fault_ == Fault::none) fault_ = fault;
  }
  template <class Visit>
  void for_faces(const Visit& visit);

  Scene<D> scene_;
  Particles<D> particles_;
  Grid<D> grid_;
  Slabs<D> slabs_;
  Team team_;
  ActiveNodes active_nodes_;
  void (*advance_)(Mpm&, double);
  std::array<bool, D> periodic_{};
  std::vector<MovingWall<D>> walls_;
  std::unique_ptr<ConsistentMass<D>> consistent_mass_;
  std::unique_ptr<ExpandedInverse<D>> expanded_inverse_;
  double least_mass_ = 0;
  double time_ = 0;
  double dt_ = 0;  ///< of the last step
  std::int64_t steps_ = 0;
  std::int64_t moves_ = 0;
  std::atomic<bool> must_sort_{false};
  Fault fault_ = Fault::none;
  std::vector<std::uint32_t> place_;  ///< of the particle with each id, for the surface load
  std::vector<Vec<D>> load_;          ///< its forces
};

extern template class Mpm<1>;
extern template class Mpm<2>;
extern template class Mpm<3>;

}  // namespace mpmvv::solver
