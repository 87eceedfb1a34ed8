#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "solver/simd/pack.hpp"
#include "solver/stencils/block.hpp"

namespace mpmvv::solver {

/// A particle for a kernel that serves one or a pack: reads and writes its fields.
template <int D>
struct ParticleRef {
  std::uint32_t index;
  int place;  ///< in its block

  template <class T>
  [[gnu::always_inline]] const T& of(const std::vector<T>& field) const {
    return field[index];
  }
  template <class T>
  [[gnu::always_inline]] const T& of(const T* of_block) const {
    return of_block[place];
  }
  [[gnu::always_inline]] PaddedMat<D> of(const MatrixBlock<D>& of_block) const {
    PaddedMat<D> matrix = PaddedMat<D>::Zero();
    for (int c = 0; c < D; ++c)
      for (int r = 0; r < D; ++r) matrix(r, c) = of_block.entry[r][c][place];
    return matrix;
  }
  template <class T>
  [[gnu::always_inline]] void set(std::vector<T>& field, const auto& value) const {
    field[index] = value.template topRows<D>();
  }
  template <class T>
  [[gnu::always_inline]] void add(std::vector<T>& field, const auto& value) const {
    field[index] += value.template topRows<D>();
  }
};

/// Up to four particles of a block for a node kernel. In the place of those that are missing stand others, which are
/// read but not written.
template <int D>
class ParticlePack {
 public:
  /// `particles` are the indices of a block's, of which the pack begins at `place`.
  [[gnu::always_inline]] ParticlePack(const std::uint32_t* particles, int place, int count)
      : particle_(particles + place), place_(place), count_(count) {}

  int count() const { return count_; }

  [[gnu::always_inline]] Pack of(const std::vector<double>& field) const {
    return Pack(Double4{field[particle_[0]], field[particle_[1]], field[particle_[2]], field[particle_[3]]});
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const std::vector<Eigen::Matrix<double, R, C>>& field) const {
    const auto numbers = [&](int lane) { return field[particle_[lane]].data(); };
    return load<R, C>({numbers(0), numbers(1), numbers(2), numbers(3)});
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const Eigen::Matrix<double, R, C>* of_block) const {
    const auto numbers = [&](int lane) { return of_block[place_ + lane].data(); };
    return load<R, C>({numbers(0), numbers(1), numbers(2), numbers(3)});
  }
  [[gnu::always_inline]] PackMat<D> of(const MatrixBlock<D>& of_block) const {
    PackMat<D> packs;
    for (int c = 0; c < D; ++c)
      for (int r = 0; r < D; ++r) packs(r, c) = Pack(load4(&of_block.entry[r][c][place_]));
    return packs;
  }

  template <int R, int C>
  [[gnu::always_inline]] void set(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    if (count_ == 4) {
      const auto all = [&](int lane) { return field[particle_[lane]].data(); };
      return store_packs<R * C>(value.data(), {all(0), all(1), all(2), all(3)});
    }
    Eigen::Matrix<double, R, C> of_none;
    const auto numbers = [&](int lane) { return lane < count_ ? field[particle_[lane]].data() : of_none.data(); };
    store_packs<R * C>(value.data(), {numbers(0), numbers(1), numbers(2), numbers(3)});
  }
  template <int R, int C>
  [[gnu::always_inline]] void add(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    set(field, Eigen::Matrix<Pack, R, C>(of(field) + value));
  }

 private:
  template <int R, int C>
  [[gnu::always_inline]] static Eigen::Matrix<Pack, R, C> load(const std::array<const double*, 4>& from) {
    Eigen::Matrix<Pack, R, C> packs;
    load_packs<R * C>(from, packs.data());
    return packs;
  }

  const std::uint32_t* particle_;
  int place_, count_;
};

/// Calls visit(pack, k) for every four particles of a block or a tile, the first of them at place k. What is beyond the
/// last repeats it.
template <int D, class Particles, class Visit>
[[gnu::always_inline]] inline void for_packs(const Particles& some, const Visit& visit) {
  for (int k = 0; k < some.count; k += 4)
    visit(ParticlePack<D>(some.particle, k, std::min(some.count - k, 4)), k);
}

}  // namespace mpmvv::solver
