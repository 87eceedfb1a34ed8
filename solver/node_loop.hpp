#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
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

/// What the companies of a run add to its nodes; for an operation that does not map, nothing.
template <int D, class Source>
struct RunSources {
  RunSources() {}  // leaves them as they are
  std::array<Source, block_size<D> / 4> of_company;
};
template <int D>
struct RunSources<D, void> {};

/// Visits four particles at a time, run by run, whose sums are brought to the nodes at its end.
template <int D, int K, Evaluates evaluates, class... Ops>
[[gnu::noinline, gnu::flatten]] void visit_companies(const PointBlock<D, K, evaluates>& block, const Grid<D>& grid,
                                                     const Ops&... op) {
  using Nodes = SharedNodes<D, K, evaluates>;
  std::tuple<RunSources<D, std::invoke_result_t<const Ops&, const Company<D>&, const Nodes&, decltype(block)>>...>
      sources;
  for (int r = 0; r < block.runs; ++r) {
    const int begin = block.run[r], end = block.run[r + 1];
    for (int k = begin; k < end; k += 4) {
      const int count = std::min(end - k, 4);
      const Company<D> company(block.begin, k, count);
      const Nodes nodes(block, grid, k);
      const auto visit = [&]<class Op>(const Op& own, auto& of_op) {
        if constexpr (maps_to_nodes<Op>)
          of_op.of_company[static_cast<std::size_t>((k - begin) / 4)] = first_of(own(company, nodes, block), count);
        else
          own(company, nodes, block);
      };
      std::apply([&](auto&... of_op) { (visit(op, of_op), ...); }, sources);
    }
    const Nodes run(block, grid, begin);
    const int companies = (end - begin + 3) / 4;
    const auto scatter = [&]<class Op>(const Op& own, const auto& of_op) {
      if constexpr (maps_to_nodes<Op>) run.scatter(of_op.of_company.data(), companies, own.field());
    };
    std::apply([&](const auto&... of_op) { (scatter(op, of_op), ...); }, sources);
  }
}

/// Operations on the particles of a block and their nodes.
template <class... Ops>
struct NodeLoop {
  std::tuple<Ops...> ops;

  template <int D>
  void operator()(const auto& block, const Grid<D>& grid) const {
    std::apply([&](const Ops&... op) { (prepare(op, block, grid), ...); }, ops);
    if constexpr (requires { block.runs; })
      if (block.in_companies) return std::apply([&](const Ops&... op) { visit_companies(block, grid, op...); }, ops);
    std::apply([&](const Ops&... op) { visit_each(block, grid, op...); }, ops);
  }

 private:
  static void prepare(const auto& op, const auto& block, const auto& grid) {
    if constexpr (requires { op.prepare(block, grid); }) op.prepare(block, grid);
  }
};

template <>
struct NodeLoop<> {
  template <int D>
  void operator()(const Block<D>&, const Grid<D>&) const {}
};

template <class... Ops>
NodeLoop<Ops...> node_loop(const Ops&... ops) {
  if constexpr (sizeof...(Ops) == 0)
    return {};
  else
    return {std::tuple<Ops...>{ops...}};
}

template <class Op>
inline constexpr bool uses_gradients = false;
template <class Op>
requires Op::uses_gradients inline constexpr bool uses_gradients<Op> = true;
template <class... Ops>
inline constexpr bool uses_gradients<NodeLoop<Ops...>> = (uses_gradients<Ops> || ...);

}  // namespace mpmvv::solver
