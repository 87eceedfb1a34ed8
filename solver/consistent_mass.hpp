#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "solver/consistent_mass_settings.hpp"
#include "solver/round_trip.hpp"

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
/// Systems are solved by conjugate gradients for all components at once, each product being a sweep over the particles
/// (as fast as with an assembled sparse matrix, which would have to be assembled first). They are preconditioned by
/// diag(m) and start from the lumped solution: where nothing is held residuals then sum to zero, and particles get the
/// whole momentum however soon the iteration ends. It ends after ln(2 / (tolerance sqrt(ε))) / 2 sqrt(ε) steps at most,
/// by which the tolerance is reached, eigenvalues being as they are.
template <int D>
class ConsistentMass {
 public:
  using Field = std::vector<Packed<D>>;

  ConsistentMass(Mpm<D>& s, const ConsistentMassSettings& settings, double cell_mass);

  /// To be called when masses or positions have changed, before `multiply`.
  void set_couplings(Mpm<D>& s);

  /// q = Cᵀ M̂ u of a constrained field, u = C u.
  void multiply(Mpm<D>& s, const Field& u, Field& q);

  /// Solves Cᵀ M̂ u = Cᵀ b, u = C u, starting from the u given. Nodes up to `least_mass` keep theirs.
  template <class V>
  void solve(Mpm<D>& s, const std::vector<V>& b, double least_mass, Field& u) {
    for (std::size_t n = 0; n < b.size(); ++n) residual_[n] = b[n].template head<lanes<D>>();
    solve(s, least_mass, u);
  }

 private:
  /// As above, b being in `residual_`.
  void solve(Mpm<D>& s, double least_mass, Field& u);
  static double full_mass(const Mpm<D>& s, std::size_t n, double cell_mass);
  void invert_diagonal(Mpm<D>& s, double least_mass);
  Packed<D> product(const Field& a, const Field& b) const;
  Packed<D> residual_norm() const;  ///< squared

  ConsistentMassSettings settings_;
  int most_iterations_;
  RoundTrip<D> round_trip_;
  std::vector<double> share_;             ///< one over the number of nodes that folding makes one
  std::vector<double> covered_mass_;      ///< θ m_full
  std::vector<double> coverage_;          ///< c
  std::vector<Packed<D + 1>> couplings_;  ///< in component D: M c
  Field inverse_;                         ///< of Cᵀ diag(m) C, zero where nothing is to be solved
  Field residual_, direction_, image_;    ///< of the iteration
  Field covered_;                         ///< c u, for the product
};

/// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j of a scalar, to where masses are.
template <int D>
struct MapScalarRoundTrip {
  const Particles<D>& particles;
  const std::vector<double>& u;
  std::vector<Packed<D + 1>>& product;

  auto& field() const { return product; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto& nodes, const auto&) const {
    return packed_alone<D>(who.of(particles.m) * nodes.gather(u));
  }
};

template <int D>
ConsistentMass<D>::ConsistentMass(Mpm<D>& s, const ConsistentMassSettings& settings, double cell_mass)
    : settings_(settings),
      most_iterations_(
          static_cast<int>(std::ceil(0.5 / std::sqrt(settings.lumped_share) *
                                     std::log(2 / settings.tolerance / std::sqrt(settings.lumped_share))))),
      round_trip_(s, most_iterations_) {
  const std::size_t nodes = s.grid().size();
  for (Field* field : {&inverse_, &residual_, &direction_, &image_, &covered_}) field->resize(nodes, Packed<D>::Zero());
  coverage_.resize(nodes);
  couplings_.assign(nodes, packed<D>(Vec<D>::Zero(), 1));
  s.fold(couplings_);
  for (const auto& images : couplings_) share_.push_back(1 / images[D]);
  for (std::size_t n = 0; n < nodes; ++n) covered_mass_.push_back(settings.covered * full_mass(s, n, cell_mass));
}

template <int D>
double ConsistentMass<D>::full_mass(const Mpm<D>& s, std::size_t n, double cell_mass) {
  const auto i = s.grid().index(n);
  for (std::size_t d = 0; d < D; ++d)
    if (!s.periodic()[d] && (i[d] == 0 || i[d] == s.grid().inside(static_cast<int>(d)) - 1)) cell_mass /= 2;
  return cell_mass;
}

template <int D>
void ConsistentMass<D>::set_couplings(Mpm<D>& s) {
  const double most = std::sqrt(1 - settings_.lumped_share);
  for (std::size_t n = 0; n < coverage_.size(); ++n) {
    const double m = s.grid().m(n);
    coverage_[n] = m < covered_mass_[n] ? most * m / covered_mass_[n] : most;
  }
  s.clear(couplings_);
  s.sweep(node_loop(MapScalarRoundTrip<D>{s.particles(), coverage_, couplings_}));
  s.fold(couplings_);
  round_trip_.prepare(s);
}

template <int D>
void ConsistentMass<D>::multiply(Mpm<D>& s, const Field& u, Field& q) {
  for (std::size_t n = 0; n < u.size(); ++n) covered_[n] = coverage_[n] * u[n];
  s.clear(q);
  round_trip_.map(s, covered_, q);
  s.fold(q);
  for (std::size_t n = 0; n < u.size(); ++n)
    q[n] = s.grid().m(n) * u[n] - coverage_[n] * (couplings_[n][D] * u[n] - q[n]);
  s.constrain_transposed(q);
}

template <int D>
void ConsistentMass<D>::solve(Mpm<D>& s, double least_mass, Field& u) {
  const auto sum = [](const Packed<D>& components) { return components.template head<D>().sum(); };
  const auto quotient = [](double a, double b) { return b > 0 ? a / b : 0.0; };
  set_couplings(s);
  invert_diagonal(s, least_mass);
  s.constrain_transposed(residual_);
  const double round_off = 1e-28 * sum(residual_norm());

  multiply(s, u, image_);
  for (std::size_t n = 0; n < u.size(); ++n) residual_[n] -= image_[n];
  Packed<D> norm = residual_norm(), previous = Packed<D>::Zero();
  const double enough = std::max(settings_.tolerance * settings_.tolerance * sum(norm), round_off);
  for (int k = 0; k < most_iterations_ && sum(norm) > enough; ++k) {  // a NaN ends it
    const Packed<D> beta = norm.binaryExpr(previous, quotient);
    for (std::size_t n = 0; n < u.size(); ++n)
      direction_[n] = inverse_[n].cwiseProduct(residual_[n]) + beta.cwiseProduct(direction_[n]);
    s.constrain(direction_);
    multiply(s, direction_, image_);
    const Packed<D> alpha = norm.binaryExpr(product(direction_, image_), quotient);
    for (std::size_t n = 0; n < u.size(); ++n) {
      u[n] += alpha.cwiseProduct(direction_[n]);
      residual_[n] -= alpha.cwiseProduct(image_[n]);
    }
    previous = norm;
    norm = residual_norm();
  }
}

template <int D>
void ConsistentMass<D>::invert_diagonal(Mpm<D>& s, double least_mass) {
  std::fill(inverse_.begin(), inverse_.end(), Packed<D>::Ones());
  s.constrain(inverse_);
  for (std::size_t n = 0; n < inverse_.size(); ++n) inverse_[n] *= s.grid().m(n) > least_mass ? s.grid().m(n) : 0;
  s.constrain_transposed(inverse_);
  for (auto& diagonal : inverse_) diagonal = diagonal.unaryExpr([](double m) { return m > 0 ? 1 / m : 0.0; });
}

template <int D>
Packed<D> ConsistentMass<D>::product(const Field& a, const Field& b) const {
  Packed<D> sum = Packed<D>::Zero();
  for (std::size_t n = 0; n < a.size(); ++n) sum += share_[n] * a[n].cwiseProduct(b[n]);
  return sum;
}

template <int D>
Packed<D> ConsistentMass<D>::residual_norm() const {
  Packed<D> sum = Packed<D>::Zero();
  for (std::size_t n = 0; n < residual_.size(); ++n)
    sum += share_[n] * residual_[n].cwiseProduct(inverse_[n]).cwiseProduct(residual_[n]);
  return sum;
}

extern template class ConsistentMass<1>;
extern template class ConsistentMass<2>;
extern template class ConsistentMass<3>;

}  // namespace mpmvv::solver
