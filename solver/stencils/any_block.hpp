#pragma once
#include <type_traits>
#include <variant>

#include "solver/basis/bases.hpp"
#include "solver/stencils/cpdi_block.hpp"
#include "solver/stencils/point_block.hpp"

namespace mpmvv::solver {

/// The type of block that a basis takes.
template <int D, class B>
using BlockOf =
    std::conditional_t<B::width == ParticleWidth::domain, CpdiBlock<D, B::support>, PointBlock<D, B::support>>;

namespace detail {

/// Appends to a std::variant those of the types that it does not hold yet, each once.
template <class Variant, class... Types>
struct Distinct {
  using type = Variant;
};
template <class... Known, class Next, class... Rest>
struct Distinct<std::variant<Known...>, Next, Rest...>
    : std::conditional_t<(std::is_same_v<Known, Next> || ...), Distinct<std::variant<Known...>, Rest...>,
                         Distinct<std::variant<Known..., Next>, Rest...>> {};

template <int D, class Any>
struct BlocksOf;
template <int D, class... B>
struct BlocksOf<D, std::variant<B...>> : Distinct<std::variant<>, BlockOf<D, B>...> {};

}  // namespace detail

/// A block of any basis. Bases of points share one type of block if they have the same support, and so do bases of
/// domains. The code by which a sweep handles a block is then shared, too.
template <int D>
using AnyBlock = typename detail::BlocksOf<D, AnyBasis>::type;

template <int D>
Block<D>& common(AnyBlock<D>& block) {
  return std::visit([](auto& own) -> Block<D>& { return own; }, block);
}

}  // namespace mpmvv::solver
