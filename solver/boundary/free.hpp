#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// No treatment: the zero-traction surface of the body.
struct Free {
  static constexpr std::string_view word = "free";
  static constexpr bool holds = false;

  template <int D, class T>
  void sum_images(Grid<D>&, Face, Array<T>&) const {}
  template <int D>
  void constrain(Grid<D>&, Face, Array<Padded<D>>&) const {}
};

}  // namespace mpmvv::solver
