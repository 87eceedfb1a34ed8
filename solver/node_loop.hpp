#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/company.hpp"
#include "solver/grid.hpp"
#include "solver/shared_nodes.hpp"

namespace mpmvv::solver {

/// Visits the particles of a block in four interleaved parts: neighbours add to the same nodes, and one would have to
/// wait for the other.
template <class Visit>
[[gnu::always_inline]] inline void for_interleaved(int count, const Visit& visit) {
  const int stride = (count + 3) / 4;
  for (int start = 0; start < stride; ++start)
    for (int k = start; k < count; k += stride) visit(k);
}

/// An operation on particles and their nodes, one by one or in companies: op(who, nodes, block) reads and writes
/// particles through `who`, a `One` or a `Company`, and nodes through `nodes`. One that maps to nodes returns what the
/// particles add to those of its `field()`. An op.prepare(block, grid), where there is such a thing, comes before all
/// operations of the loop; none of these may read on nodes, nor prepare from particles, what another one changes.
template <class Op>
inline constexpr bool maps_to_nodes = requires(const Op& op) {
  op.field();
};

/// Visits each particle by itself.
template <int D, class... Ops>
void visit_each(const auto& block, const Grid<D>& grid, const Ops&... op) {
  for_interleaved(block.count, [&](int k) {
    const auto nodes = block.stencil(k, grid);
    const One<D> one{block.begin, k};
    const auto visit = [&]<class Op>(const Op& own) {
      if constexpr (maps_to_nodes<Op>)
        nodes.scatter(own(one, nodes, block), own.field());
      else
        own(one, nodes, block);
    };
    (visit(op), ...);
  });
}

/// An operation on the companies of a run, and what these add to its nodes.
template <int D, class Op, class Nodes, class Block>
class OnRun {
 public:
  explicit OnRun(const Op& op) : op_(op) {}  // leaves the sources unset: each is written before it is read

  void visit(const Company<D>& company, const Nodes& nodes, const Block& block, int place) {
    if constexpr (maps_to_nodes<Op>)
      sources_[static_cast<std::size_t>(place)] = first_of(op_(company, nodes, block), company.count());
    else
      op_(company, nodes, block);
  }
  void scatter(const Nodes& nodes, int companies) const {
    if constexpr (maps_to_nodes<Op>) nodes.scatter(sources_.data(), companies, op_.field());
  }

 private:
  struct None {};
  using Source = std::invoke_result_t<const Op&, const Company<D>&, const Nodes&, const Block&>;
  const Op& op_;
  std::conditional_t<maps_to_nodes<Op>, std::array<Source, block_size<D> / 4>, None> sources_;
};

/// Visits four particles at a time, run by run, whose sums are brought to the nodes at its end.
template <class Nodes, int D, class Block, class... Op>
void visit_runs(const Block& block, const Grid<D>& grid, OnRun<D, Op, Nodes, Block>&&... on_run) {
  for (int r = 0; r < block.runs; ++r) {
    const int begin = block.run[r], end = block.run[r + 1];
    for (int k = begin; k < end; k += 4) {
      const Company<D> company(block.begin, k, std::min(end - k, 4));
      const Nodes nodes(block, grid, k);
      (on_run.visit(company, nodes, block, (k - begin) / 4), ...);
    }
    const Nodes nodes(block, grid, begin);
    const int companies = (end - begin + 3) / 4;
    (on_run.scatter(nodes, companies), ...);
  }
}

template <int D, int K, Evaluates evaluates, class... Ops>
[[gnu::noinline, gnu::flatten]] void visit_companies(const PointBlock<D, K, evaluates>& block, const Grid<D>& grid,
                                                     const Ops&... op) {
  using Nodes = SharedNodes<D, K, evaluates>;
  visit_runs<Nodes>(block, grid, OnRun<D, Ops, Nodes, PointBlock<D, K, evaluates>>(op)...);
}

/// An operation as a base: compiles in less time than a tuple's elements.
template <class Op>
struct Held {
  Op held;
};

/// Operations, of different types, on the particles of a block and their nodes.
template <class... Ops>
struct NodeLoop : Held<Ops>... {
  template <int D>
  void operator()(const auto& block, const Grid<D>& grid) const {
    if constexpr (sizeof...(Ops) > 0) {
      (prepare(Held<Ops>::held, block, grid), ...);
      if constexpr (requires { block.runs; })
        if (block.in_companies) return visit_companies(block, grid, Held<Ops>::held...);
      visit_each(block, grid, Held<Ops>::held...);
    }
  }

 private:
  static void prepare(const auto& op, const auto& block, const auto& grid) {
    if constexpr (requires { op.prepare(block, grid); }) op.prepare(block, grid);
  }
};

template <class... Ops>
NodeLoop<Ops...> node_loop(const Ops&... ops) {
  return {Held<Ops>{ops}...};
}

template <class Op>
inline constexpr bool uses_gradients = false;
template <class Op>
requires Op::uses_gradients inline constexpr bool uses_gradients<Op> = true;
template <class... Ops>
inline constexpr bool uses_gradients<NodeLoop<Ops...>> = (uses_gradients<Ops> || ...);

}  // namespace mpmvv::solver
