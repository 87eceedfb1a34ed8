#pragma once
#include <type_traits>
#include <variant>

#include "solver/basis/bases.hpp"
#include "solver/stencils/cpdi_block.hpp"
#include "solver/stencils/point_block.hpp"

namespace mpmvv::solver {

/// The block of a basis.
template <int D, class B>
using BlockOf =
    std::conditional_t<B::width == ParticleWidth::domain, CpdiBlock<D, B::support>, PointBlock<D, B::support>>;

namespace detail {

/// A variant of the types without their repetitions.
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

/// A block of any basis. Bases with the same support share a type, and so all that a sweep does with it.
template <int D>
using AnyBlock = typename detail::BlocksOf<D, AnyBasis>::type;

template <int D>
Block<D>& common(AnyBlock<D>& block) {
  return std::visit([](auto& own) -> Block<D>& { return own; }, block);
}

}  // namespace mpmvv::solver
