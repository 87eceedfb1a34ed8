#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

/// Names become types by the lists of bases, boundaries, materials and velocity updates, variants all of them.
namespace mpmvv::solver {

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

}  // namespace mpmvv::solver
