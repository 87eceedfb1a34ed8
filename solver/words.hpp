#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/basis/b2cpdi.hpp"
#include "solver/basis/b2gimp.hpp"
#include "solver/basis/cpdi.hpp"
#include "solver/basis/gimp.hpp"
#include "solver/basis/linear.hpp"
#include "solver/basis/open_bspline.hpp"
#include "solver/boundary/dirichlet.hpp"
#include "solver/boundary/free.hpp"
#include "solver/boundary/mirror.hpp"
#include "solver/boundary/periodic.hpp"
#include "solver/boundary/symmetry.hpp"
#include "solver/boundary/wall.hpp"
#include "solver/material/linear_elastic.hpp"
#include "solver/material/mie_gruneisen.hpp"
#include "solver/material/neo_hookean_log.hpp"
#include "solver/material/neo_hookean_square.hpp"
#include "solver/velocity_update/apic.hpp"
#include "solver/velocity_update/fmpm.hpp"
#include "solver/velocity_update/pic.hpp"
#include "solver/velocity_update/xpic.hpp"

/// The one place where names become types: add a line here for a new basis, boundary or material.
namespace mpmvv::solver {

using AnyBasis = std::variant<Linear,        //
                              BSpline2,      //
                              BSpline3,      //
                              BSpline2Open,  //
                              BSpline3Open,  //
                              UGimp,         //
                              Gimp,          //
                              CpGimp,        //
                              Cpdi,          //
                              B2Gimp,        //
                              B2Cpdi>;

using AnyBoundary = std::variant<Periodic,   //
                                 Dirichlet,  //
                                 Symmetry,   //
                                 Mirror,     //
                                 Free,       //
                                 Wall>;

using AnyMaterial = std::variant<NeoHookeanLog,     //
                                 NeoHookeanSquare,  //
                                 LinearElastic,     //
                                 MieGruneisen>;

using AnyVelocityUpdate = std::variant<Flip,  //
                                       Xpic,  //
                                       Fmpm,  //
                                       Pic,   //
                                       Apic>;

/// The words of the alternatives of a variant, in its order.
template <class... Types>
constexpr std::array<std::string_view, sizeof...(Types)> words_of(const std::variant<Types...>*) {
  return {Types::word...};
}

template <class Any>
constexpr auto words() {
  return words_of(static_cast<const Any*>(nullptr));
}

/// The alternative with this word, default-constructed; false when there is none.
template <class Any, std::size_t k = 0>
bool from_word(std::string_view word, Any& any) {
  if constexpr (k < std::variant_size_v<Any>) {
    using Type = std::variant_alternative_t<k, Any>;
    if (Type::word != word) return from_word<Any, k + 1>(word, any);
    any.template emplace<Type>();
    return true;
  }
  return false;
}

inline bool expands_inverse(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class U>(const U&) {
        return requires(U u) {
          u.order;
        };
      },
      update);
}

inline ParticleWidth width_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::width; }, basis);
}

inline int ghosts_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return B::ghost; }, basis);
}

}  // namespace mpmvv::solver
