#pragma once
#include <cstddef>

namespace mpmvv {

/// Stands for a member of any type.
struct Anything {
  template <class T>
  operator T() const;
};

/// How many members an aggregate has.
template <class Part, class... Members>
consteval std::ptrdiff_t count_members() {
  if constexpr (requires { Part{Members{}..., Anything{}}; })
    return count_members<Part, Members..., Anything>();
  else
    return sizeof...(Members);
}

}  // namespace mpmvv
