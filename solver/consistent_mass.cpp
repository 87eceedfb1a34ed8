#include "solver/consistent_mass.hpp"

#include <algorithm>
#include <cmath>

#include "solver/kernels/add_mass_product.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

template <int D>
ConsistentMass<D>::ConsistentMass(Step<D>& s, const ConsistentMassSettings& settings, double cell_mass)
    : settings_(settings),
      most_iterations_(
          static_cast<int>(std::ceil(0.5 / std::sqrt(settings.lumped_share) *
                                     std::log(2 / settings.tolerance / std::sqrt(settings.lumped_share))))),
      product_(s, most_iterations_) {
  const std::size_t nodes = s.grid().size();
  for (Field* field : {&inverse_, &residual_, &direction_, &image_, &covered_}) field->resize(nodes, Padded<D>::Zero());
  coverage_.resize(nodes);
  covered_sums_.assign(nodes, padded_alone<D>(1));
  s.sum_images(covered_sums_);
  for (const auto& images : covered_sums_) share_.push_back(1 / images[D]);
  for (std::size_t n = 0; n < nodes; ++n) covered_mass_.push_back(settings.covered * full_mass(s, n, cell_mass));
}

template <int D>
double ConsistentMass<D>::full_mass(const Step<D>& s, std::size_t n, double cell_mass) {
  const auto i = s.grid().index(n);
  const auto ends_at = [&](std::size_t face) {
    const AnyBoundary& boundary = s.scene().boundary[face];
    return !std::holds_alternative<Periodic>(boundary) && !std::holds_alternative<Mirror>(boundary);
  };
  for (std::size_t d = 0; d < D; ++d) {
    if (i[d] == 0 && ends_at(2 * d)) cell_mass /= 2;
    if (i[d] == s.grid().inside(static_cast<int>(d)) - 1 && ends_at(2 * d + 1)) cell_mass /= 2;
  }
  return cell_mass;
}

template <int D>
void ConsistentMass<D>::set_coverage(Step<D>& s) {
  if (covered_after_ == s.moves()) return;
  covered_after_ = s.moves();
  const double most = std::sqrt(1 - settings_.lumped_share);
  for (std::size_t n = 0; n < coverage_.size(); ++n) {
    const double m = s.grid().m(n);
    coverage_[n] = padded_alone<D>(m < covered_mass_[n] ? most * m / covered_mass_[n] : most);
  }
  s.clear(covered_sums_);
  s.sweep({AddMassProduct<D, Padded<D + 1>>{s.particles(), coverage_, covered_sums_}});
  s.sum_images(covered_sums_);
  product_.prepare(s);
}

template <int D>
void ConsistentMass<D>::multiply(Step<D>& s, const Field& u, Field& q) {
  for (std::size_t n = 0; n < u.size(); ++n) covered_[n] = coverage_[n][D] * u[n];
  s.clear(q);
  product_.add(s, covered_, q);
  s.sum_images(q);
  for (std::size_t n = 0; n < u.size(); ++n)
    q[n] = s.grid().m(n) * u[n] - coverage_[n][D] * (covered_sums_[n][D] * u[n] - q[n]);
  s.constrain_transposed(q);
}

template <int D>
void ConsistentMass<D>::solve(Step<D>& s, double least_mass, Field& u) {
  const auto sum = [](const Padded<D>& components) { return components.template head<D>().sum(); };
  const auto quotient = [](double a, double b) { return b > 0 ? a / b : 0.0; };
  set_coverage(s);
  invert_diagonal(s, least_mass);
  s.constrain_transposed(residual_);
  const double round_off = 1e-28 * sum(residual_norm());

  multiply(s, u, image_);
  for (std::size_t n = 0; n < u.size(); ++n) residual_[n] -= image_[n];
  Padded<D> norm = residual_norm(), previous = Padded<D>::Zero();
  const double enough = std::max(settings_.tolerance * settings_.tolerance * sum(norm), round_off);
  for (int k = 0; k < most_iterations_ && sum(norm) > enough; ++k) {  // a NaN ends it
    const Padded<D> beta = norm.binaryExpr(previous, quotient);
    for (std::size_t n = 0; n < u.size(); ++n)
      direction_[n] = inverse_[n].cwiseProduct(residual_[n]) + beta.cwiseProduct(direction_[n]);
    s.constrain(direction_);
    multiply(s, direction_, image_);
    const Padded<D> alpha = norm.binaryExpr(product(direction_, image_), quotient);
    for (std::size_t n = 0; n < u.size(); ++n) {
      u[n] += alpha.cwiseProduct(direction_[n]);
      residual_[n] -= alpha.cwiseProduct(image_[n]);
    }
    previous = norm;
    norm = residual_norm();
  }
}

template <int D>
void ConsistentMass<D>::invert_diagonal(Step<D>& s, double least_mass) {
  std::fill(inverse_.begin(), inverse_.end(), Padded<D>::Ones());
  s.constrain(inverse_);
  for (std::size_t n = 0; n < inverse_.size(); ++n) inverse_[n] *= s.grid().m(n) > least_mass ? s.grid().m(n) : 0;
  s.constrain_transposed(inverse_);
  for (auto& diagonal : inverse_) diagonal = diagonal.unaryExpr([](double m) { return m > 0 ? 1 / m : 0.0; });
}

template <int D>
Padded<D> ConsistentMass<D>::product(const Field& a, const Field& b) const {
  Padded<D> sum = Padded<D>::Zero();
  for (std::size_t n = 0; n < a.size(); ++n) sum += share_[n] * a[n].cwiseProduct(b[n]);
  return sum;
}

template <int D>
Padded<D> ConsistentMass<D>::residual_norm() const {
  Padded<D> sum = Padded<D>::Zero();
  for (std::size_t n = 0; n < residual_.size(); ++n)
    sum += share_[n] * residual_[n].cwiseProduct(inverse_[n]).cwiseProduct(residual_[n]);
  return sum;
}

template class ConsistentMass<1>;
template class ConsistentMass<2>;
template class ConsistentMass<3>;

}  // namespace mpmvv::solver
