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
  std::size_t begin;  ///< of the block
  int place;          ///< in it

  std::size_t index() const { return begin + static_cast<std::size_t>(place); }

  template <class T>
  [[gnu::always_inline]] const T& of(const std::vector<T>& field) const {
    return field[index()];
  }
  template <class T>
  [[gnu::always_inline]] const T& of(const T* of_block) const {
    return of_block[place];
  }
  [[gnu::always_inline]] const PaddedMat<D>& of(const MatrixBlock<D>& of_block) const { return of_block.each[place]; }
  template <class T>
  [[gnu::always_inline]] void set(std::vector<T>& field, const auto& value) const {
    field[index()] = value.template topRows<D>();
  }
  template <class T>
  [[gnu::always_inline]] void add(std::vector<T>& field, const auto& value) const {
    field[index()] += value.template topRows<D>();
  }
};

/// Up to four particles of a block, one after the other, for a node kernel. Where fewer are left the last is read again
/// in the place of each that is missing, and nothing is written for these.
template <int D>
class ParticlePack {
 public:
  [[gnu::always_inline]] ParticlePack(std::size_t begin, int place, int count)
      : begin_(begin), place_(place), count_(count) {}

  int count() const { return count_; }

  [[gnu::always_inline]] Pack of(const std::vector<double>& field) const { return four(&field[begin_]); }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const std::vector<Eigen::Matrix<double, R, C>>& field) const {
    return of(&field[begin_]);
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const Eigen::Matrix<double, R, C>* of_block) const {
    Eigen::Matrix<Pack, R, C> packs;
    load_packs<R * C>(each<R * C>(of_block[place_].data()), packs.data());
    return packs;
  }
  /// Those have room for four.
  [[gnu::always_inline]] PackMat<D> of(const MatrixBlock<D>& of_block) const {
    PackMat<D> packs;
    for (int c = 0; c < D; ++c)
      for (int r = 0; r < D; ++r) packs(r, c) = Pack(load4(&of_block.entry[r][c][place_]));
    return packs;
  }

  template <int R, int C>
  [[gnu::always_inline]] void set(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    Eigen::Matrix<double, R, C>* const own = &field[begin_] + place_;
    if (count_ == 4)
      store_packs<R * C>(value.data(), each<R * C>(own->data()));
    else
      set_some(own, value);
  }
  template <int R, int C>
  [[gnu::always_inline]] void add(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    set(field, Eigen::Matrix<Pack, R, C>(of(field) + value));
  }

 private:
  /// Where the numbers of each are, so many to a particle; those beyond the last are its again.
  template <int n, class T>
  [[gnu::always_inline]] std::array<T*, 4> each(T* first) const {
    const auto of_lane = [=, this](int lane) { return first + (count_ == 4 ? lane : std::min(lane, count_ - 1)) * n; };
    return {of_lane(0), of_lane(1), of_lane(2), of_lane(3)};
  }
  [[gnu::always_inline]] Pack four(const double* of_block) const {
    const auto from = each<1>(of_block + place_);
    return count_ == 4 ? Pack(load4(from[0])) : Pack(Double4{*from[0], *from[1], *from[2], *from[3]});
  }
  template <int R, int C>
  [[gnu::noinline]] void set_some(Eigen::Matrix<double, R, C>* own, const Eigen::Matrix<Pack, R, C>& value) const {
    for (int lane = 0; lane < count_; ++lane)
      own[lane] = value.unaryExpr([lane](const Pack& four) { return four[static_cast<std::size_t>(lane)]; });
  }

  std::size_t begin_;  ///< of the block
  int place_;          ///< in it, of the first
  int count_;
};

/// Calls visit(pack, k) for every four particles of a block, the first of them at place k. What is beyond the last
/// repeats it.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_packs(const Block<D>& block, const Visit& visit) {
  int k = 0;
  for (; k + 4 <= block.count; k += 4) visit(ParticlePack<D>(block.begin, k, 4), k);
  if (k < block.count) visit(ParticlePack<D>(block.begin, k, block.count - k), k);
}

}  // namespace mpmvv::solver
