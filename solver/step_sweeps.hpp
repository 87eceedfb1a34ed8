#pragma once
#include "solver/kernels/add_couplings.hpp"
#include "solver/kernels/block_kernels.hpp"
#include "solver/kernels/map_surface_load.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "solver/stencils/sweep.hpp"
#include "solver/step.hpp"
#include "solver/velocity_update/affine.hpp"

/// The parts of a step that visit particles.
namespace mpmvv::solver {

template <int D>
void Step<D>::sweep(std::initializer_list<AnyKernel<D>> kernels) {
  finish_waiting();
  note(solver::sweep<D>(Adds::to_nodes, scene_.basis, particles_, grid_, slabs_, pool_, kernels));
}

template <int D>
void Step<D>::check() {
  finish_waiting();
  note(solver::sweep<D>(Adds::nothing, scene_.basis, particles_, grid_, slabs_, pool_, {}));
}

/// Makes the sweep that waits, by visit(its kernels), and returns what `visit` returns. After that no sweep waits, even
/// if a body force has thrown: made again, the sweep would move particles a second time.
template <int D>
auto Step<D>::end_waiting(const auto& visit) {
  struct Clear {
    WaitingSweep<D>& waiting;
    ~Clear() { waiting.clear(); }
  } const at_end{waiting_};
  ++moves_;
  return visit(waiting_.kernels());
}

template <int D>
void Step<D>::finish_waiting() {
  if (waiting_.empty()) return;
  note_waiting(end_waiting([this](const auto& kernels) {
    return solver::sweep<D>(Adds::nothing, scene_.basis, particles_, grid_, slabs_, pool_, kernels);
  }));
  if (must_sort_.exchange(false)) sort();
}

/// Maps particles to p and f, which have been cleared, in one visit with the sweep that waits, if there is one. If that
/// sweep finds that particles must be sorted, they are sorted and mapped anew: the kernels must then leave particles as
/// they are. A material with a history would take the second mapping for another step. With it the sweep that waits is
/// made first, on its own.
template <int D>
void Step<D>::map(std::initializer_list<AnyKernel<D>> kernels) {
  const bool may_map_anew = particles_.thermal.empty();
  if (!waiting_.empty() && may_map_anew) {
    const auto [in_waiting, in_kernels] = end_waiting([&](const auto& waiting) {
      return sweep_twice<D>(scene_.basis, particles_, grid_, slabs_, pool_, waiting, must_sort_, kernels);
    });
    note_waiting(in_waiting);
    if (!must_sort_.exchange(false)) return note(in_kernels);
    sort();
    clear_grid();
    matrix_to_fill();
  }
  sweep(kernels);
}

/// Returns the mass matrix, cleared, if a mapping of momenta has to add couplings to it: where the step will multiply
/// by one. They cost less there than in a sweep of their own, which would evaluate the stencils once more.
template <int D>
MassMatrix<D>* Step<D>::matrix_to_fill() {
  if (!expanded_inverse_ || !expands(scene_.velocity_update, steps_)) return nullptr;
  MassMatrix<D>* const matrix = expanded_inverse_->product().matrix();
  if constexpr (D < 3)
    if (matrix) matrix->clear();
  return matrix;
}

template <int D>
void Step<D>::note(Fault found) {
  if (fault_ == Fault::none) fault_ = found;
}

template <int D>
void Step<D>::note_waiting(Fault found) {
  if (fault_ == Fault::none && found != Fault::none) is_late_ = waiting_since_ < steps_;
  note(found);
}

template <int D>
void Step<D>::map_momentum() {
  clear_grid();
  map({MapAffineMomentum<D>{particles_, grid_}, MapMomentum<D>{particles_, grid_},
       AddCouplings<D>{particles_, matrix_to_fill()}});
  sum_momentum_images();
}

template <int D>
void Step<D>::map_momentum_and_forces() {
  clear_grid();
  map_forces(Fused{MapMomentum<D>{particles_, grid_}, MapForces<D>{particles_, grid_}},
             MapAffineMomentum<D>{particles_, grid_}, AddCouplings<D>{particles_, matrix_to_fill()});
  sum_momentum_images();
  sum_images(grid_.f);
}

template <int D>
void Step<D>::deform_and_map_forces(const DeformationStep& deform) {
  finish_waiting();  // a mapping anew would update F twice
  map_forces(MapForces<D>{particles_, grid_}, EvaluateVelocityGradient<D>{particles_, grid_},
             UpdateDeformation<D>{particles_, deform});
  sum_images(grid_.f);
}

/// Maps f by the kernel `mapping`, after the kernels `before` and those of stress and body force. What images add is to
/// be summed afterwards.
template <int D>
void Step<D>::map_forces(const auto& mapping, const auto&... before) {
  BodyForce<D>* const force = scene_.body_force_on == BodyForceOn::particles ? scene_.body_force : nullptr;
  if (force) force->prepare(time_);
  const EvaluateStress<D> stress{particles_, scene_.material, dt_};
  map({before..., stress, EvaluateBodyForce<D>{particles_, force, time_}, mapping});
  if (scene_.surface_load) add_surface_load();
}

template <int D>
void Step<D>::add_surface_load() {
  scene_.surface_load->forces(time_, load_.data());
  note(map_surface_load(scene_.basis, *scene_.surface_load, load_.data(), place_, particles_, grid_));
}

template <int D>
void Step<D>::update_velocities_and_map_momentum(double dt) {
  const VelocityFields<D> fields = velocity_fields(dt);
  clear_momentum();
  sweep({UpdateAffineField<D>{particles_, grid_}, UpdateVelocityAndRate<D>{particles_, grid_, fields, dt},
         MapAffineMomentum<D>{particles_, grid_}, MapMomentum<D>{particles_, grid_}});
  sum_momentum_images();
}

/// Makes the last sweep of a step with the kernel that updates velocity and position, and with the kernels `after` it.
template <int D>
template <template <int, bool> class Update>
void Step<D>::last_sweep_of(double dt, const auto&... after) {
  const VelocityFields<D> fields = velocity_fields(dt);
  const UpdateAffineField<D> affine{particles_, grid_};
  if (are_flip(fields, grid_))
    last_sweep(affine, Update<D, true>{particles_, grid_, fields, dt}, after...);
  else
    last_sweep(affine, Update<D, false>{particles_, grid_, fields, dt}, after...);
  if (fields.include(grid_.f)) finish_waiting();  // the next mapping clears f before a sweep that waits
}

template <int D>
void Step<D>::update_particles(double dt) {
  last_sweep_of<UpdateVelocityAndPosition>(dt);
}

template <int D>
void Step<D>::update_particles(double dt, const DeformationStep& deform) {
  last_sweep_of<UpdateParticle>(dt, UpdateDeformation<D>{particles_, deform});
}

template <int D>
void Step<D>::move_particles_and_deform(double dt, const DeformationStep& deform) {
  last_sweep(MoveByRate<D>{particles_, dt}, EvaluateVelocityGradient<D>{particles_, grid_},
             UpdateDeformation<D>{particles_, deform});
}

}  // namespace mpmvv::solver
