#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

/// Turns names into types. The lists of bases, boundaries, materials and velocity updates are variants, each of whose
/// alternatives has a `word`, its name.
namespace mpmvv::solver {

/// Returns the words of the alternatives of a variant, in its order.
template <class... Types>
constexpr std::array<std::string_view, sizeof...(Types)> words_of(const std::variant<Types...>*) {
  return {Types::word...};
}

template <class Any>
constexpr auto words() {
  return words_of(static_cast<const Any*>(nullptr));
}

/// Sets `any` to the alternative with this word, default-constructed. Returns false when there is none.
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
