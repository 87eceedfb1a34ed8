#pragma once
#include <optional>
#include <vector>

#include "solver/grid.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// A node kernel of `rk4`: adds a stage's rate k to the step's sum and sets the state of the next stage, y = y^n +
/// `next` k, or, where none follows, that of the step's end, y = y^{n+1}, the sum.
template <int D>
struct AdvanceStage {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  double weight;               ///< s
  std::optional<double> next;  ///< s

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    auto& [start, sum] = particles.stages;
    const auto v = nodes.gather_with_gradient(grid.v);
    advance(who, particles.F, start.F, sum.F, v.gradient.template topRows<D>() * who.of(particles.F));
    advance(who, particles.x, start.x, sum.x, v.value.template head<D>());
    advance(who, particles.v, start.v, sum.v, nodes.gather(grid.a).template head<D>());
  }

 private:
  template <class T>
  void advance(const auto& who, std::vector<T>& now, const std::vector<T>& start, std::vector<T>& sum,
               const auto& rate_of) const {
    const auto rate = rate_of.eval();
    who.add(sum, (weight * rate).eval());
    if (next)
      who.set(now, (who.of(start) + *next * rate).eval());
    else
      who.set(now, who.of(sum));
  }
};

}  // namespace mpmvv::solver
