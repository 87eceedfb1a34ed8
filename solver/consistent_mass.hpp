#pragma once
#include <cstddef>
#include <vector>

#include "solver/array.hpp"
#include "solver/consistent_mass_settings.hpp"
#include "solver/mass_product.hpp"

namespace mpmvv::solver {

/// The consistent mass matrix of the particles' quadrature, M_ij = Σ_p m_p N_ip N_jp, SᵀMS in N §2.1. Its row sums are
/// the lumped masses m_i, from which it differs by what couples two nodes,
///   (M u)_i = m_i u_i - Σ_j M_ij (u_i - u_j).
///
/// M is singular where there are fewer particles than nodes, and nearly so at a node that particles reach with the
/// tail N of its function alone: M_ii ~ N² vanishes before the force ~ ∇N does, and any time step is then too long.
/// Couplings are therefore multiplied by c_i c_j, which leaves symmetry and row sums as they are:
///   M̂ u = m_i u_i - c_i Σ_j M_ij c_j (u_i - u_j),   c_i = sqrt(1 - ε) min(1, m_i / θ m_full),
/// m_full being a full cell's mass, half of it on a face of the domain. A node with less than θ of that passes to the
/// lumped mass as its own vanishes; among all others M̂ is (1 - ε) M + ε diag(m). Relative to diag(m) its eigenvalues
/// lie in [ε, 1]: no mode of forces is accelerated more than 1/ε times as much as with the lumped mass. A mode of M
/// with eigenvalue s is changed by the fraction ε (1 - s)/s, on smooth modes ε times the error of the lumped mass.
///
/// Systems are solved by conjugate gradients for all components at once. They are preconditioned by diag(m) and start
/// from the lumped solution: where nothing is held residuals then sum to zero, and particles get the whole momentum
/// however soon the iteration ends. It ends after ln(2 / (tolerance sqrt(ε))) / 2 sqrt(ε) steps at most, by which the
/// tolerance is reached, eigenvalues being as they are.
template <int D>
class ConsistentMass {
 public:
  using Field = Array<Padded<D>>;

  ConsistentMass(Step<D>& s, const ConsistentMassSettings& settings, double cell_mass);

  /// To be called when masses or positions have changed, before `multiply`.
  void set_couplings(Step<D>& s);

  /// q = Cᵀ M̂ u of a constrained field, u = C u.
  void multiply(Step<D>& s, const Field& u, Field& q);

  /// Solves Cᵀ M̂ u = Cᵀ b, u = C u, starting from the u given. Nodes up to `least_mass` keep theirs.
  template <class V>
  void solve(Step<D>& s, const Array<V>& b, double least_mass, Field& u) {
    for (std::size_t n = 0; n < b.size(); ++n) residual_[n] = b[n].template head<padded_size<D>>();
    solve(s, least_mass, u);
  }

 private:
  /// As above, b being in `residual_`.
  void solve(Step<D>& s, double least_mass, Field& u);
  static double full_mass(const Step<D>& s, std::size_t n, double cell_mass);
  void invert_diagonal(Step<D>& s, double least_mass);
  Padded<D> product(const Field& a, const Field& b) const;
  Padded<D> residual_norm() const;  ///< squared

  ConsistentMassSettings settings_;
  int most_iterations_;
  MassProduct<D> product_;
  Array<double> share_;                 ///< one over the number of nodes that the boundaries make one
  Array<double> covered_mass_;          ///< θ m_full
  Array<Padded<D + 1>> coverage_;       ///< in component D, where boundaries expect a mass: c
  Array<Padded<D + 1>> couplings_;      ///< in component D: M c
  Field inverse_;                       ///< of Cᵀ diag(m) C, zero where nothing is to be solved
  Field residual_, direction_, image_;  ///< of the iteration
  Field covered_;                       ///< c u, for the product
};

extern template class ConsistentMass<1>;
extern template class ConsistentMass<2>;
extern template class ConsistentMass<3>;

}  // namespace mpmvv::solver
