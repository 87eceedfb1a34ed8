#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/array.hpp"
#include "solver/boundary/images.hpp"
#include "solver/grid.hpp"

namespace mpmvv::solver {

/// The nodes of a grid that are each other's images, and the sums over them.
template <int D>
class Orbits {
 public:
  Orbits(Images images, const Grid<D>& grid) : images_(images) {
    std::size_t all = 0;
    for_orbits(grid, [&all](const auto&) { ++all; });
    orbits_.reserve(all);
  }

  /// Lets sums give every node what it and its images hold.
  void take_all(const Grid<D>& grid) {
    orbits_.clear();
    for_orbits(grid, [this](const auto& orbit) { orbits_.push_back(orbit); });
  }

  /// Lets sums give only nodes n for which has_mass(n) holds what they and their images hold, and leave other nodes,
  /// which must hold nothing, as they are.
  template <class HasMass>
  void take_those_with_mass(const Grid<D>& grid, const HasMass& has_mass) {
    orbits_.clear();
    for_orbits(grid, [&](Orbit orbit) {
      int with_mass = 0;
      for (std::uint32_t& node : orbit) {
        if (node != none && !has_mass(node)) node = none;
        with_mass += node != none ? 1 : 0;
      }
      if (with_mass > 1) orbits_.push_back(orbit);
    });
  }

  /// Adds up a field mapped from particles: F_0 = Σ_k g^-k f_k and F_k = g^k F_0, where g leads to the next image.
  template <class T>
  void sum(Array<T>& field) const {
    if (images_ == Images::quarter_turns)
      sum_each<4>(field.data());
    else
      sum_each<2>(field.data());
  }

 private:
  /// Nodes in the order of the images. A node that is its own image stands there more than once.
  using Orbit = std::array<std::uint32_t, 4>;
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  template <class Visit>
  void for_orbits(const Grid<D>& grid, const Visit& visit) const {
    if constexpr (D > 1) {
      if (images_ == Images::none) return;
      if (images_ == Images::middle) return for_orbits_of_middle(grid, visit);
      const int nodes = grid.nodes(0), plane = nodes * nodes;
      for (int first = 0; first < static_cast<int>(grid.size()); first += plane) {
        if (images_ == Images::diagonal) for_orbits_of_diagonal(first, nodes, visit);
        if (images_ == Images::quarter_turns) for_orbits_of_quarter_turns(first, nodes, visit);
      }
    }
  }
  template <class Visit>
  static void for_orbits_of_middle(const Grid<D>& grid, const Visit& visit) {
    const int last = grid.inside(1) - 1;
    for (int j = -grid.ghost(); j <= last - j; ++j)
      grid.for_plane(1, j, last - j, [&visit](int n, int image) { visit(orbit_of(n, image)); });
  }
  template <class Visit>
  static void for_orbits_of_diagonal(int first, int nodes, const Visit& visit) {
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i <= j; ++i) visit(orbit_of(first + j * nodes + i, first + i * nodes + j));
  }
  /// Starts from the nodes of a quadrant, which includes the node in the middle, if there is one.
  template <class Visit>
  static void for_orbits_of_quarter_turns(int first, int nodes, const Visit& visit) {
    const auto at = [=](int i, int j) { return static_cast<std::uint32_t>(first + j * nodes + i); };
    const int half = nodes / 2, last = nodes - 1;
    for (int j = 0; j < nodes - half; ++j)
      for (int i = 0; i < (j == half ? nodes - half : half); ++i)
        visit(Orbit{at(i, j), at(last - j, i), at(last - i, last - j), at(j, last - i)});
  }
  static Orbit orbit_of(int n, int image) {
    return {static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(image), none, none};
  }

  /// Components are added one by one: a processor has to wait where a register is read from memory that was written as
  /// single numbers.
  template <std::size_t count, class T>
  void sum_each(T* nodes) const {
    for (const Orbit& orbit : orbits_) {
      T sum = T::Zero();
      for (std::size_t k = count; k-- > 0;) {
        sum = previous_image(images_, sum);
        if (orbit[k] == none) continue;
        for (int c = 0; c < sum.size(); ++c) sum[c] += nodes[orbit[k]][c];
      }
      for (std::size_t k = 0; k < count; ++k) {
        if (orbit[k] != none)
          for (int c = 0; c < sum.size(); ++c) nodes[orbit[k]][c] = sum[c];
        sum = next_image(images_, sum);
      }
    }
  }

  Images images_;
  std::vector<Orbit> orbits_;
};

}  // namespace mpmvv::solver
