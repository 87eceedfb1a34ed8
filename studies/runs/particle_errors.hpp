#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "solver/types.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Displacement errors of particles with their places, few enough to be kept and drawn.
class ParticleErrors {
 public:
  static constexpr std::size_t most = 1600;

  /// `spacing`: what particles are apart at rest.
  ParticleErrors(int dimension, double spacing) : dimension_(dimension), spacing_(spacing) {}

  template <int D>
  void add(const solver::Vec<D>& X, const solver::Vec<D>& x, double error) {
    constexpr int across = D < 2 ? 0 : 1;
    all_.push_back({{X[0], D < 2 ? 0 : X[across]}, {x[0], D < 2 ? 0 : x[across], error}});
  }

  /// Each, where they are few and none hides another. Else the RMS of neighbours in squares of the body at rest, at the
  /// place of one of them.
  std::vector<records::ParticleError> reduced() const;

 private:
  struct One {
    std::array<double, 2> X;  ///< reference position
    records::ParticleError now;
  };

  std::vector<records::ParticleError> in_squares(double width) const;

  int dimension_;
  double spacing_;
  std::vector<One> all_;
};

}  // namespace mpmvv::runs
