#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <variant>
#include <vector>

#include "solver/array.hpp"
#include "solver/fault.hpp"
#include "solver/kernels/block_kernels.hpp"
#include "solver/parallel/active_nodes.hpp"
#include "solver/parallel/slabs.hpp"
#include "solver/parallel/thread_pool.hpp"
#include "solver/scene.hpp"
#include "solver/stencils/kernel.hpp"
#include "solver/stencils/waiting_sweep.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

template <int D>
class ConsistentMass;
template <int D>
class ExpandedInverse;
struct Integrator;

/// What the page of an integrator is written in: sweeps over the particles and operations on the grid, each an equation
/// or a few. Users of the solver take `Mpm` (mpm.hpp).
///
/// Positions and widths change once in a step or a stage of it, last: what is mapped before has the weights of its
/// start.
template <int D>
class Step {
 public:
  using Field = Array<Padded<D>>;

  explicit Step(Scene<D> scene);  ///< throws as `Mpm` does
  ~Step();

  /// Makes so many steps, by the integrator's page, or until one finds a fault; returns how many, that one included.
  std::int64_t advance(double dt, std::int64_t steps = 1);

  Particles<D>& particles() {
    settle();
    return particles_;
  }
  Grid<D>& grid() { return grid_; }
  const Grid<D>& grid() const { return grid_; }
  const Scene<D>& scene() const { return scene_; }  ///< but for its particles
  const std::array<bool, D>& periodic() const { return periodic_; }
  double time() const { return time_; }
  void set_time(double t) { time_ = t; }         ///< of the body force, for stages within a step
  std::int64_t steps() const { return steps_; }  ///< finished ones
  std::int64_t moves() const { return moves_; }  ///< how often particles have moved or been sorted
  Fault fault() const { return fault_; }         ///< the first one found
  Vec<D> node_position(std::size_t n) const;     ///< of the node at a storage index
  bool is_accelerated(std::size_t n) const { return grid_.m(n) > least_mass_; }

  // From particles to the grid; images are summed, those that the boundaries identify among them.
  void map_momentum();             ///< m_i, p_i                                    S (1), (2), W (8), (9)
  void map_momentum_and_forces();  ///< and τ_p = τ(F_p), f_i                       S (3), (4), (16), W (12), (14)
  void deform_and_map_forces(const DeformationStep& deform);  ///< F_p by the grid's v, then τ_p = τ(F_p), f_i
  /// v_p by the velocity update and the rate at which positions will follow, then m_i, p_i of these.
  void update_velocities_and_map_momentum(double dt);

  // On the grid. With the consistent mass, M̂⁻¹ takes the place of 1/m_i.
  void set_velocity();               ///< v_i = p_i / m_i, constrained                             S (2), W (9)
  void set_stress_velocity();        ///< v_i as the stress updates take it: expanded for `fmpm`   N §2.2
  void restore_velocity();           ///< v_i = p_i / m_i again, if it has been expanded since
  void set_acceleration();           ///< a_i = f_i / m_i, constrained unless S (30) will set it   S (5), W (15), W §4
  void advance_velocity(double dt);  ///< v_i += a_i Δt, constrained                               S (6), W (16), S (30)

  // From the grid to particles: the last sweep of a step, after which all is ready for the next. A page changes nothing
  // on the grid after it (see `sweep_and_settle`).
  void update_particles(double dt);                                          ///< v_p, x_p by the velocity update
  void update_particles(double dt, const DeformationStep& deform);           ///< and F_p by the grid's v
  void move_particles_and_deform(double dt, const DeformationStep& deform);  ///< x_p at its rate, F_p by v

  /// How F follows the grid's velocity gradient for so long.
  DeformationStep deformation(double dt) const { return {dt, scene_.deformation}; }

  // What the above is made from, for a page with a sweep of its own.

  /// One visit to all particles by these kernels.
  void sweep(std::initializer_list<AnyKernel<D>> kernels);

  /// The last one of a step or of a stage: by these, then what must be ready for the next. What sets F in a step checks
  /// it, too: UpdateDeformation, or CheckDeformation beside a kernel of a page's own. It waits until particles are next
  /// asked for: where they are mapped to p and f then, both are one visit to them. Of the grid its kernels may read v
  /// and a, which stay until then. p and f are cleared before.
  template <class... Kernels>
  void sweep_and_settle(const Kernels&... kernels) {
    settle();
    waiting_.set(kernels..., UpdateWidth<D>{particles_}, SettlePosition<D>{particles_, periodic_, slabs_, must_sort_});
    waiting_since_ = steps_;
  }

  /// Calls visit(n) for every node with mass. Those without have no velocity and acceleration but what boundaries hold.
  template <class Visit>
  void for_nodes(const Visit& visit) {
    active_nodes_.visit(pool_, visit);
  }

  /// Calls visit(first, end) for each span of such nodes along the storage.
  template <class Visit>
  void for_spans_of_nodes(const Visit& visit) {
    active_nodes_.visit_spans(pool_, visit);
  }

  template <class V>
  void clear(Array<V>& field);  ///< to zero, before particles are mapped to it
  /// Adds up what images and boundaries identify, after particles have been mapped.
  template <class V>
  void sum_images(Array<V>& field);
  void sum_momentum_images();    ///< that of momenta and masses; the masses decide what `for_nodes` visits from then on
  void constrain(Field& field);  ///< v = C v, where walls stand still
  void constrain_transposed(Field& field);  ///< f = Cᵀ f

  // For velocity updates.
  void expand_velocity();                ///< v_i by the expanded inverse, on a step on which the update does so
  void expand_inverse(Field& velocity);  ///< velocities by the expanded inverse from lumped ones, as walls have it
  void hold_expanded(Field& velocity);   ///< makes what comes of it obey the faces, unless the wall method leaves it

 private:
  void make_room();
  void add_walls();
  void step(double dt);
  void settle();
  void sort();
  void note(Fault found);
  void end_waiting(Fault found);
  void map(std::initializer_list<AnyKernel<D>> kernels);
  void map_forces(const auto& with, const auto&... before);
  void add_surface_load();
  void add_grid_body_force();
  void clear_grid();
  void divide_by_mass(const auto& field, double least_mass, Field& quotient);
  void set_difference_acceleration(double dt);
  bool holds_lumped() const;
  void hold(Field& velocity);
  VelocityFields<D> velocity_fields(double dt);
  template <class Visit>
  void for_faces(const Visit& visit);

  Scene<D> scene_;
  Particles<D> particles_;
  Grid<D> grid_;
  Slabs<D> slabs_;
  ThreadPool pool_;
  ActiveNodes active_nodes_;
  const Integrator& integrator_;
  std::array<bool, D> periodic_{};
  std::vector<MovingWall<D>> walls_;
  std::unique_ptr<ConsistentMass<D>> consistent_mass_;
  std::unique_ptr<ExpandedInverse<D>> expanded_inverse_;
  double least_mass_ = 0;
  double time_ = 0;
  double dt_ = 0;  ///< of the step under way
  std::int64_t steps_ = 0;
  std::int64_t moves_ = 0;
  bool has_expanded_velocity_ = false;
  WaitingSweep<D> waiting_;
  std::int64_t waiting_since_ = 0;  ///< finished steps when it was asked for
  std::atomic<bool> must_sort_{false};
  Fault fault_ = Fault::none;
  bool is_late_ = false;        ///< the fault is of the last step, found in this one
  Array<std::uint32_t> place_;  ///< of the particle with each id, for the surface load
  std::vector<Vec<D>> load_;    ///< its forces
};

template <int D>
template <class Visit>
void Step<D>::for_faces(const Visit& visit) {
  for (int d = 0; d < D; ++d)
    for (const bool upper : {false, true})
      std::visit(
          [&](const auto& boundary) {
            visit(boundary, Face{d, upper});
          },
          scene_.boundary[static_cast<std::size_t>(2 * d + (upper ? 1 : 0))]);
}

template <int D>
template <class V>
void Step<D>::clear(Array<V>& field) {
  for_chunks(pool_, field.size(),
             [&field](std::size_t begin, std::size_t end) { std::fill(&field[begin], &field[0] + end, V::Zero()); });
}

template <int D>
template <class V>
void Step<D>::sum_images(Array<V>& field) {
  sum_over(scene_.images, grid_, field);
  for_faces([&](const auto& boundary, Face face) { boundary.sum_images(grid_, face, field); });
}

extern template class Step<1>;
extern template class Step<2>;
extern template class Step<3>;

}  // namespace mpmvv::solver
