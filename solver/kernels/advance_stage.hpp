#pragma once
#include <optional>

#include "solver/array.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// A node kernel of `rk4`. Adds `weight` times the rate k of a stage to the step's sum. Then sets the state of the next
/// stage, y = y^n + `next` k, or after the last stage that of the step's end, y = y^{n+1}, which is the sum.
template <int D>
struct AdvanceStage {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  double weight;               ///< factor of k in the sum, s
  std::optional<double> next;  ///< factor of k in the state of the next stage, s; empty for the last stage

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, const auto&) const {
    auto& [start, sum] = particles.stages;
    const auto v = nodes.gather_with_gradient(grid.v);
    advance(p, particles.F, start.F, sum.F, v.gradient.template topRows<D>() * particles.F[p]);
    advance(p, particles.x, start.x, sum.x, v.value.template head<D>());
    advance(p, particles.v, start.v, sum.v, nodes.gather(grid.a).template head<D>());
  }

 private:
  template <class T>
  void advance(std::size_t p, Array<T>& now, const Array<T>& start, Array<T>& sum, const auto& rate_of) const {
    const T rate = rate_of;
    sum[p] += weight * rate;
    now[p] = next ? T(start[p] + *next * rate) : sum[p];
  }
};

}  // namespace mpmvv::solver
