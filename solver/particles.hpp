#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "solver/array.hpp"
#include "solver/material/thermal_state.hpp"
#include "solver/parallel/thread_pool.hpp"
#include "solver/types.hpp"

namespace mpmvv::solver {

/// The fields that a step advances: position, velocity and deformation gradient.
template <int D>
struct Motion {
  Array<Vec<D>> x, v;
  Array<Mat<D>> F;
};

/// The material points, one array per field. Fields that the scheme does not need stay empty.
template <int D>
struct Particles {
  Array<std::uint32_t> id;  ///< position in the order of creation; survives sorting
  Array<Vec<D>> x;          ///< position, m
  Array<Vec<D>> v;          ///< velocity, m/s
  Array<Mat<D>> F;          ///< deformation gradient
  Array<double> m;          ///< mass, kg
  Array<double> V0;         ///< reference volume, m³
  Array<Vec<D>> l;          ///< width in units of h, for bases that take one
  Array<Vec<D>> l0;         ///< reference width in units of h, where the width follows the deformation
  Array<Mat<D>> R;          ///< edges of the domain as columns, in units of h, for bases that take a domain
  Array<Mat<D>> R0;         ///< reference edges in units of h, where the domain follows the deformation

  Array<Vec<D>> X;  ///< reference position, m, for body forces that read it

  Array<Mat<D>> C;  ///< gradient of the affine velocity field, 1/s, for `apic`

  Array<ThermalState> thermal;  ///< for materials with a history

  Array<Vec<D>> rate;  ///< (x' - x)/Δt of the step, for integrators that move particles after mapping a velocity anew

  struct {
    Motion<D> start;  ///< at the start of the step
    Motion<D> sum;    ///< `start` plus the weighted rates of the stages so far
  } stages;           ///< for integrators that have stages

  std::size_t size() const { return x.size(); }

  /// Resizes the fields that every scheme has (id, x, v, F, m, V0) and numbers the particles in `id`. Those of new
  /// particles are to be set: Eigen leaves their x, v and F without a defined value.
  void resize(std::size_t n) {
    id.resize(n), x.resize(n), v.resize(n), F.resize(n), m.resize(n), V0.resize(n);
    std::iota(id.begin(), id.end(), 0U);
  }

  /// Updates widths and edges that follow the deformation, of the particles from `begin` to before `end`.
  void update_widths(std::size_t begin, std::size_t end) {
    if (!l0.empty())
      for (std::size_t p = begin; p < end; ++p) l[p] = l0[p].cwiseProduct(F[p].diagonal());
    if (!R0.empty())
      for (std::size_t p = begin; p < end; ++p) R[p].noalias() = F[p] * R0[p];
  }

  /// Copies the current state to both fields of `stages`.
  void start_stages() {
    for (Motion<D>* motion : {&stages.start, &stages.sum}) motion->x = x, motion->v = v, motion->F = F;
  }

  /// Reorders every field that is in use: new k = old order[k]. Leaves out `rate`, which is only read in the step that
  /// has set it.
  void permute(const Array<std::uint32_t>& order, ThreadPool& pool) {
    const auto reorder = [&](auto& sorted, auto&... fields) { (permute(fields, order, pool, sorted), ...); };
    auto& [start, sum] = stages;
    reorder(spare_.ids, id);
    reorder(spare_.numbers, m, V0);
    reorder(spare_.vectors, x, v, l, l0, X, start.x, start.v, sum.x, sum.v);
    reorder(spare_.matrices, F, R, R0, C, start.F, sum.F);
    reorder(spare_.states, thermal);
  }

 private:
  template <class T>
  static void permute(Array<T>& field, const Array<std::uint32_t>& order, ThreadPool& pool, Array<T>& sorted) {
    if (field.empty()) return;
    sorted.resize(field.size());
    for_chunks(pool, field.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) sorted[p] = field[order[p]];
    });
    field.swap(sorted);
  }

  struct {
    Array<std::uint32_t> ids;
    Array<double> numbers;
    Array<Vec<D>> vectors;
    Array<Mat<D>> matrices;
    Array<ThermalState> states;
  } spare_;  ///< arrays that fields are sorted into. They are kept: new memory takes the system longer than the sort
};

}  // namespace mpmvv::solver
