#pragma once
#include <limits>
#include <vector>

#include "studies/checks/mapping/mapped_body.hpp"
#include "studies/checks/mapping/sample_lattice.hpp"

namespace mpmvv::checks::mapping {

/// The value of a measure where its property has no meaning for a subject.
inline constexpr double no_meaning = -std::numeric_limits<double>::infinity();

/// A mapped body with one of its mass matrices, and its particle basis sampled on a lattice. Properties are measured on
/// it.
template <int D>
class Subject {
 public:
  Subject(const MappedBody<D>& body, MassKind mass)
      : body_(body),
        mass_(mass),
        basis_(body.basis(mass)),
        lattice_(body.grid()),
        N_(body.field().weights(lattice_.points())),
        phi_(basis_.at(N_)) {
    for (std::size_t k = 0; k < lattice_.points().size(); ++k)
      if (body.tiling().contains(lattice_.points()[k])) in_body_.push_back(static_cast<Eigen::Index>(k));
    peaks_ = phi_(Eigen::all, in_body_).cwiseAbs().rowwise().maxCoeff();
    const solver::Vec<D> depth = 3 * body.grid().h;
    for (std::size_t p = 0; p < body.tiling().x.size(); ++p)
      if (body.tiling().box_is_inside(p, depth)) interior_.push_back(p);
  }

  const MappedBody<D>& body() const { return body_; }
  MassKind mass() const { return mass_; }
  const ParticleBasis& basis() const { return basis_; }
  const SampleLattice<D>& lattice() const { return lattice_; }
  const typename NodalBasis<D>::Matrix& N() const { return N_; }  ///< nodal functions on the lattice
  const Eigen::MatrixXd& phi() const { return phi_; }             ///< Φ_p on the lattice, particles x points
  double largest() const { return phi_.cwiseAbs().maxCoeff(); }   ///< the largest |Φ_p| of all particles

  /// Returns the largest |Φ_p| in the body. With a consistent mass it may be far larger outside, at nodes that the body
  /// hardly reaches.
  double peak(std::size_t p) const { return peaks_[static_cast<Eigen::Index>(p)]; }
  const std::vector<Eigen::Index>& in_body() const { return in_body_; }  ///< indices of lattice points in the body

  /// Returns the particles whose boxes lie at least three cells from every face of the block.
  const std::vector<std::size_t>& interior() const { return interior_; }

  /// The body at one of three places on its way over a cell of the fixed grid, and the particle basis there.
  struct Translated {
    MappedBody<D> body;
    ParticleBasis basis;
  };
  const std::vector<Translated>& way() const {
    const solver::Vec<D> quarter = (0.1 * solver::Vec<D>::Unit(0) + solver::Vec<D>::Constant(0.15));  // (1, 0.6) / 4
    for (int k = static_cast<int>(way_.size()) + 1; k < 4; ++k) {
      const solver::Vec<D> u = k * quarter.cwiseProduct(body_.grid().h);
      const auto moved = body_.moved(body_.grid(), body_.tiling().translated(u));
      way_.push_back({moved, moved.basis(mass_)});
    }
    return way_;
  }

  /// Returns Φ_p(x_p + s) for each offset s.
  Eigen::RowVectorXd around(std::size_t p, const Points<D>& offsets) const {
    Points<D> at;
    for (const auto& s : offsets) at.push_back(body_.tiling().x[p] + s);
    return basis_.psi().col(static_cast<Eigen::Index>(p)).transpose() * body_.field().weights(at);
  }

 private:
  const MappedBody<D>& body_;
  MassKind mass_;
  ParticleBasis basis_;
  SampleLattice<D> lattice_;
  typename NodalBasis<D>::Matrix N_;
  Eigen::MatrixXd phi_;
  std::vector<Eigen::Index> in_body_;
  Eigen::VectorXd peaks_;
  std::vector<std::size_t> interior_;
  mutable std::vector<Translated> way_;  ///< filled at the first call of `way`
};

/// Returns offsets up to two cells from a particle along each axis, symmetric about 0: the k-th from the end is minus
/// the k-th.
template <int D>
Points<D> symmetric_offsets(const OverlayGrid<D>& grid) {
  constexpr int half = D == 1 ? 24 : 8;
  Points<D> offsets;
  for (int j = D == 1 ? 0 : -half; j <= (D == 1 ? 0 : half); ++j)
    for (int i = -half; i <= half; ++i) {
      solver::Vec<D> s;
      s[D - 1] = 2 * grid.h[D - 1] * j / half;
      s[0] = 2 * grid.h[0] * i / half;
      offsets.push_back(s);
    }
  return offsets;
}

}  // namespace mpmvv::checks::mapping
