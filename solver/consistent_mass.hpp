#pragma once
#include <cstddef>
#include <cstdint>

#include "solver/array.hpp"
#include "solver/consistent_mass_settings.hpp"
#include "solver/mass_product.hpp"

namespace mpmvv::solver {

/// The consistent mass matrix of the particles' quadrature, M_ij = Σ_p m_p N_ip N_jp, SᵀMS in N §2.1. Its row sums are
/// the lumped masses m_i, so it is the lumped matrix less the couplings between nodes,
///   (M u)_i = m_i u_i - Σ_j M_ij (u_i - u_j).
///
/// M is singular where there are fewer particles than nodes. It is nearly singular at a node that particles reach only
/// with the tail of its function N: there M_ii ~ N² vanishes before the force ~ ∇N does, and any time step is too long.
/// Couplings are therefore multiplied by c_i c_j, which leaves symmetry and row sums as they are:
///   M̂ u = m_i u_i - c_i Σ_j M_ij c_j (u_i - u_j),   c_i = sqrt(1 - ε) min(1, m_i / θ m_full),
/// where m_full is a full cell's mass, halved for each face that the node lies on and that is neither periodic nor
/// mirror. As the mass of a node falls from θ m_full to zero, the node passes to the lumped mass; among all other nodes
/// M̂ is (1 - ε) M + ε diag(m). Relative to diag(m) the eigenvalues of M̂ lie in [ε, 1]: no mode of forces is
/// accelerated more than 1/ε times as much as with the lumped mass. An eigenvalue s of M changes by the fraction
/// ε (1 - s)/s, on smooth modes ε times the error of the lumped mass.
///
/// C stands for what faces make of a field while walls stand still (`Step::constrain`). Systems are solved by conjugate
/// gradients for all components at once, preconditioned by Cᵀ diag(m) C and started from the lumped solution. Residuals
/// then sum to zero where nothing is held, and particles get the whole momentum however soon the iteration ends. It
/// ends after at most ln(2 / (tolerance sqrt(ε))) / (2 sqrt(ε)) iterations, by which the tolerance is reached because
/// the eigenvalues lie in [ε, 1].
template <int D>
class ConsistentMass {
 public:
  using Field = Array<Padded<D>>;

  ConsistentMass(Step<D>& s, const ConsistentMassSettings& settings, double cell_mass);

  /// Computes c and M c, unless positions are those of the last call. To be called before `multiply`. `solve` does so
  /// itself.
  void set_coverage(Step<D>& s);

  /// Sets q = Cᵀ M̂ u. The field u must be constrained, u = C u.
  void multiply(Step<D>& s, const Field& u, Field& q);

  /// Solves Cᵀ M̂ u = Cᵀ b, u = C u, starting from the u given. Nodes with a mass up to `least_mass` keep their value.
  template <class V>
  void solve(Step<D>& s, const Array<V>& b, double least_mass, Field& u) {
    for (std::size_t n = 0; n < b.size(); ++n) residual_[n] = b[n].template head<padded_size<D>>();
    solve(s, least_mass, u);
  }

 private:
  /// Does the same with the b that is in `residual_`.
  void solve(Step<D>& s, double least_mass, Field& u);
  static double full_mass(const Step<D>& s, std::size_t n, double cell_mass);
  void invert_diagonal(Step<D>& s, double least_mass);
  Padded<D> product(const Field& a, const Field& b) const;
  Padded<D> residual_norm() const;  ///< for each component, the square of the norm that `inverse_` defines

  ConsistentMassSettings settings_;
  int most_iterations_;
  MassProduct<D> product_;
  Array<double> share_;                 ///< one over the number of nodes that `sum_images` adds up on a node
  Array<double> covered_mass_;          ///< θ m_full
  Array<Padded<D + 1>> coverage_;       ///< c in component D, where boundaries expect a mass
  Array<Padded<D + 1>> covered_sums_;   ///< M c in component D
  Field inverse_;                       ///< inverse of Cᵀ diag(m) C, zero where nothing is to be solved
  Field residual_, direction_, image_;  ///< of the iteration; the image is Cᵀ M̂ times the direction
  Field covered_;                       ///< c u, which `multiply` multiplies by M
  std::int64_t covered_after_ = -1;     ///< `Step::moves` when c and M c were computed
};

extern template class ConsistentMass<1>;
extern template class ConsistentMass<2>;
extern template class ConsistentMass<3>;

}  // namespace mpmvv::solver
