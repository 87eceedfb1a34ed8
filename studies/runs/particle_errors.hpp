#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "solver/types.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// The displacement errors of particles with their places, reduced to at most `most` so that they can be kept and
/// drawn.
class ParticleErrors {
 public:
  static constexpr std::size_t most = 1600;

  /// `spacing` is the distance between neighbouring particles at rest.
  ParticleErrors(int dimension, double spacing) : dimension_(dimension), spacing_(spacing) {}

  template <int D>
  void add(const solver::Vec<D>& X, const solver::Vec<D>& x, double error) {
    constexpr int across = D < 2 ? 0 : 1;
    all_.push_back({{X[0], D < 2 ? 0 : X[across]}, {x[0], D < 2 ? 0 : x[across], error}});
  }

  /// Returns each error where they are few and, in fewer than three dimensions, none hides another. Otherwise it
  /// returns the RMS of neighbours in squares of the body at rest, at the place of the one nearest to the square's
  /// middle.
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
