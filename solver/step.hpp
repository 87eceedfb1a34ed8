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
#include "solver/boundary/orbits.hpp"
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
template <int D>
class MassMatrix;
struct Integrator;

/// The operations with which the page of an integrator is written: sweeps over the particles and operations on the
/// grid, each of them one equation or a few. Users of the solver take `Mpm` (mpm.hpp). Its operations are defined in
/// step.cpp, and in step_grid.hpp (on nodes) and step_sweeps.hpp (on particles), which step.cpp includes.
///
/// Positions and widths change only in the last sweep of a step, or of each stage of a step. All that is mapped before
/// uses the weights at the start of the step or stage.
template <int D>
class Step {
 public:
  using Field = Array<Padded<D>>;

  explicit Step(Scene<D> scene);  ///< throws what the constructor of `Mpm` throws
  ~Step();

  /// Makes this number of steps by the integrator's page, or ends with the first that has a fault. Returns how many
  /// steps were made, including that one.
  std::int64_t advance(double dt, std::int64_t steps = 1);
  void check();  ///< finds the faults of the current positions and widths, which a step finds when it maps particles

  Particles<D>& particles() {
    finish_waiting();
    return particles_;
  }
  Grid<D>& grid() { return grid_; }
  const Grid<D>& grid() const { return grid_; }
  const Scene<D>& scene() const { return scene_; }  ///< without its particles, which have moved to `particles`
  const std::array<bool, D>& periodic() const { return periodic_; }
  const Integrator& integrator() const { return integrator_; }
  double time() const { return time_; }
  void set_time(double t) { time_ = t; }         ///< sets the time of body and surface forces, for a stage in a step
  std::int64_t steps() const { return steps_; }  ///< number of finished steps
  double dt() const { return dt_; }              ///< length of the current step, between steps of the last one
  std::int64_t moves() const { return moves_; }  ///< how often particles have moved or been sorted
  Fault fault() const { return fault_; }         ///< the first fault found
  Vec<D> node_position(std::size_t n) const;     ///< position of the node at a storage index
  bool is_accelerated(std::size_t n) const { return grid_.m(n) > least_mass_; }

  // From particles to the grid. These also sum over images, and over nodes that boundaries identify.
  void map_momentum();             ///< m_i, p_i                                    S (1), (2), W (8), (9)
  void map_momentum_and_forces();  ///< also τ_p = τ(F_p), f_i                      S (3), (4), (16), W (12), (14)
  void deform_and_map_forces(const DeformationStep& deform);  ///< F_p by the grid's v, then τ_p = τ(F_p), f_i
  /// Sets v_p by the velocity update, and the rate at which positions will follow. Then maps m_i, p_i of the new v_p.
  void update_velocities_and_map_momentum(double dt);

  // On the grid. With the consistent mass, M̂⁻¹ takes the place of 1/m_i. Where velocities are expanded afterwards and
  // the wall method is `velocity`, v_i and a_i are not constrained here.
  void set_velocity();               ///< v_i = p_i / m_i, constrained                             S (2), W (9)
  void set_stress_velocity();        ///< v_i as the stress updates take it: expanded for `fmpm`   N §2.3, task 5
  void restore_velocity();           ///< v_i = p_i / m_i again, where F followed another v_i (see step_grid.hpp)
  void set_acceleration();           ///< a_i = f_i / m_i, constrained unless S (30) will set it   S (5), W (15), W §4
  void advance_velocity(double dt);  ///< v_i += a_i Δt, constrained                               S (6), W (16), S (30)

  // From the grid to particles: the last sweep of a step, after which particles are ready for the next one. After it a
  // page must not change the grid (see `last_sweep`).
  void update_particles(double dt);                                          ///< v_p, x_p by the velocity update
  void update_particles(double dt, const DeformationStep& deform);           ///< also F_p by the grid's v
  void move_particles_and_deform(double dt, const DeformationStep& deform);  ///< x_p at the rate set before, F_p by v

  /// Returns how F follows the grid's velocity gradient over a time dt.
  DeformationStep deformation(double dt) const { return {dt, scene_.deformation}; }

  // The parts of which the operations above are made, for pages that write a sweep of their own.

  /// Visits all particles once, with these kernels in turn on each block.
  void sweep(std::initializer_list<AnyKernel<D>> kernels);

  /// Asks for the last sweep of a step or of a stage: these kernels, then those that update widths and bring particles
  /// back in through periodic faces. Whatever sets F in a step must also check it. `UpdateDeformation` does so itself;
  /// a page whose own kernel sets F adds `CheckDeformation`.
  ///
  /// The sweep waits until particles are next asked for. If they are mapped to p and f then, both sweeps are one visit
  /// to the particles. Of the grid the kernels may read only v and a, which stay as they are until then. p and f are
  /// cleared before the visit.
  template <class... Kernels>
  void last_sweep(const Kernels&... kernels) {
    finish_waiting();
    waiting_.set(kernels..., UpdateWidth<D>{particles_}, WrapPosition<D>{particles_, periodic_, slabs_, must_sort_});
    waiting_since_ = steps_;
  }

  /// Calls visit(n) for every node with mass. On nodes without mass velocity and acceleration are zero, except where
  /// boundaries set them.
  template <class Visit>
  void for_nodes(const Visit& visit) {
    active_nodes_.visit(pool_, visit);
  }

  /// Calls visit(first, end) for each span of nodes with mass along the storage.
  template <class Visit>
  void for_spans_of_nodes(const Visit& visit) {
    active_nodes_.visit_spans(pool_, visit);
  }

  template <class V>
  void clear(Array<V>& field);  ///< sets a field to zero, before particles are mapped to it
  /// Adds up the values of nodes that images and boundaries identify, after particles have been mapped; where the scene
  /// has images, after `sum_momentum_images` for the same positions.
  template <class V>
  void sum_images(Array<V>& field);
  void sum_momentum_images();               ///< `sum_images` of p; then `for_nodes` visits the nodes that have mass now
  void constrain(Field& field);             ///< v = C v: makes a field obey faces, and walls as if these stood still
  void constrain_transposed(Field& field);  ///< f = Cᵀ f, for forces

  // For velocity updates.
  void expand_velocity();                ///< v_i by the expanded inverse, on steps on which the update expands it
  void expand_inverse(Field& velocity);  ///< expands lumped velocities, on free nodes alone with `elimination`
  /// Holds expanded velocities at faces and walls, unless the wall method is `lumped`.
  void hold_after_expansion(Field& velocity);

 private:
  void make_room();
  void add_walls();
  void step(double dt);
  void finish_waiting();  ///< makes the sweep that waits, if there is one
  void sort();
  void note(Fault found);
  void note_waiting(Fault found);
  auto end_waiting(const auto& visit);
  void map(std::initializer_list<AnyKernel<D>> kernels);
  MassMatrix<D>* matrix_to_fill();
  void map_forces(const auto& mapping, const auto&... before);
  template <template <int, bool> class Update>
  void last_sweep_of(double dt, const auto&... after);
  void add_surface_load();
  void add_grid_body_force();
  void clear_grid();
  void clear_momentum();
  bool find_active_nodes();
  bool needs_whole_orbits() const;
  void divide_by_mass(const auto& field, double least_mass, Field& quotient);
  void set_difference_acceleration(double dt);
  bool holds_before_expansion() const;
  void hold(Field& velocity);
  VelocityFields<D> velocity_fields(double dt);
  template <class V>
  void sum_over_faces(Array<V>& field);
  template <class Visit>
  void for_faces(const Visit& visit);

  Scene<D> scene_;
  Particles<D> particles_;
  Grid<D> grid_;
  Slabs<D> slabs_;
  ThreadPool pool_;
  Orbits<D> orbits_;
  ActiveNodes active_nodes_;
  const Integrator& integrator_;
  std::array<bool, D> periodic_{};
  std::vector<MovingWall<D>> walls_;
  std::unique_ptr<ConsistentMass<D>> consistent_mass_;
  std::unique_ptr<ExpandedInverse<D>> expanded_inverse_;
  double least_mass_ = 0;
  double time_ = 0;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  std::int64_t moves_ = 0;
  bool has_expanded_velocity_ = false;
  bool has_mapped_ = false;  ///< whether momenta were mapped since `active_nodes_` were found
  WaitingSweep<D> waiting_;
  std::int64_t waiting_since_ = 0;  ///< `steps_` when the sweep that waits was asked for
  std::atomic<bool> must_sort_{false};
  Fault fault_ = Fault::none;
  bool is_late_ = false;        ///< whether the fault is of the previous step, and was found in this one
  Array<std::uint32_t> place_;  ///< index of the particle with each id, for the surface load
  std::vector<Vec<D>> load_;    ///< forces of the surface load
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
  sum_over_faces(field);
  orbits_.sum(field);
}

template <int D>
template <class V>
void Step<D>::sum_over_faces(Array<V>& field) {
  for_faces([&](const auto& boundary, Face face) { boundary.sum_images(grid_, face, field); });
}

extern template class Step<1>;
extern template class Step<2>;
extern template class Step<3>;

}  // namespace mpmvv::solver
