#pragma once
#include <algorithm>
#include <concepts>
#include <string_view>

namespace mpmvv::solver {

/// Which width of each particle a basis takes.
enum class ParticleWidth {
  none,       ///< none: the basis is a function of the position alone
  reference,  ///< l_p⁰, which does not change
  current,    ///< l_p⁰ diag F, W (63)
  domain      ///< no width: the basis is evaluated at the corners of the particle's domain
};

/// How far from its particle a corner of a domain may lie along each axis, in cells.
inline constexpr int domain_reach = 2;

/// Returns how far from its particle a basis is evaluated at most, in cells.
constexpr int reach(ParticleWidth width) {
  return width == ParticleWidth::domain ? domain_reach : 0;
}

/// A point on one axis, in units of the cell width h.
struct AxisPoint {
  double xi;     ///< distance from the domain's lower face
  int cells;     ///< cells of the domain along this axis
  double width;  ///< width of the particle, for bases that take one
};

/// What a basis must offer; `mass_cutoff` alone is optional. A basis is one-dimensional; the solver forms tensor
/// products, S (18).
///   word          its name in study files and on the command line
///   support       number of nodes that reach a point
///   extra_inside  degrees of freedom in the domain beyond one per cell
///   ghost         layers of nodes beyond each face. The basis may be evaluated up to ghost - max(1, (support - 1)/2)
///                 cells out of the domain (the division rounds down), and with ghost = 0 only in it
///   width         which particle width it takes
///   position      where the i-th degree of freedom sits, in cells: with these Σ_i x_i ∇N_i = I
///   evaluate      writes the weights N and gradients dN (per cell width) of the `support` nodes; returns the index of
///                 the first of them
///   mass_cutoff   see `mass_cutoff_of` in bases.hpp; needed where gradients jump from cell to cell
template <class B>
concept Basis = requires(const B basis, AxisPoint point, double* N, double* dN) {
  { B::word } -> std::convertible_to<std::string_view>;
  { B::support } -> std::convertible_to<int>;
  { B::extra_inside } -> std::convertible_to<int>;
  { B::ghost } -> std::convertible_to<int>;
  { B::width } -> std::convertible_to<ParticleWidth>;
  { B::position(int{}, int{}) } -> std::same_as<double>;
  { basis.evaluate(point, N, dN) } -> std::same_as<int>;
};

/// How many cells out of the domain a particle may lie with this basis. The corners of its domain, if it has one, may
/// lie further out by their reach.
template <class B>
inline constexpr int cells_beyond = B::ghost == 0 ? 0 : B::ghost - std::max(1, (B::support - 1) / 2) - reach(B::width);

/// Whether the set of nodes that a point reaches changes half-way between nodes, and not on nodes. It does where an odd
/// number of functions, centred on nodes, overlap. Particles are sorted by this. If it is wrong for a basis, runs with
/// that basis are slower, and their results are the same but for round-off.
template <class B>
inline constexpr bool changes_between_nodes = B::ghost > 0 && B::support % 2 == 1;

}  // namespace mpmvv::solver
