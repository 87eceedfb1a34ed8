#pragma once
#include <array>
#include <cmath>

#include "tests/benchmark/measure.hpp"

/// The multiply-adds and the bytes that a step cannot do without, per particle: the report holds them against what the
/// machine can do.
namespace mpmvv {

/// Of USL and CD: at each of the s^D nodes the weight and its gradient (products of axes' values: D - 1 and D (D - 1)),
/// mass and momentum to the grid (1 + D), force (D²), velocity and acceleration back (2 D), velocity gradient (D²);
/// then F (D³), τ (D³), V⁰τ (D²), positions and velocities (2 D). Each of the k - 1 products of an expanded inverse:
/// the weight, velocities to particles and momentum back (2 D) at each node. The axes' own polynomials, the logarithm,
/// the body force and the grid are left out. The corners of a domain reach more nodes than s^D, or those several times.
inline double least_multiply_adds(int D, const solver::AnyBasis& basis, int products) {
  const int support = std::visit([]<class B>(const B&) { return B::support; }, basis);
  const double at_node = (D - 1) + D * (D - 1) + (1 + D) + D * D + 2 * D + D * D;
  const double at_node_of_product = (D - 1) + 2 * D;
  return (at_node + products * at_node_of_product) * std::pow(support, D) + 2 * D * D * D + D * D + 2 * D;
}

/// x, v and F read and written once, mass, reference volume and identity read; the grid is shared by many particles.
/// Widths and edges that follow F are written and their reference read; others are read. A product reads where
/// particles are and how wide, and their mass.
inline double least_bytes(int D, const solver::AnyBasis& basis, int products) {
  const auto width = static_cast<std::size_t>(solver::width_of(basis));
  const std::array<int, 4> widths_of_step{0, D, 2 * D, 2 * D * D}, widths_of_product{0, D, D, D * D};
  const double step = 2 * (2 * D + D * D) + 2 + widths_of_step[width];
  const double product = D + 1 + widths_of_product[width];
  return sizeof(double) * (step + products * product) + sizeof(std::uint32_t);
}

/// `products`: of the consistent mass matrix with a velocity field.
inline void count_least_work(benchmark::State& state, int D, const solver::AnyBasis& basis, int products = 0) {
  state.counters["least_multiply_adds"] = least_multiply_adds(D, basis, products);
  state.counters["least_bytes"] = least_bytes(D, basis, products);
}

}  // namespace mpmvv
