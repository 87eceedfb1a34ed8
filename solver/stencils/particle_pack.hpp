#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/simd/pack.hpp"
#include "solver/stencils/block.hpp"

namespace mpmvv::solver {

/// A particle for a kernel that serves one or a pack: reads and writes its fields.
template <int D>
struct ParticleRef {
  std::size_t index;
  int place;  ///< in its block

  template <class T>
  [[gnu::always_inline]] const T& of(const std::vector<T>& field) const {
    return field[index];
  }
  template <class T>
  [[gnu::always_inline]] const T& of(const T* of_block) const {
    return of_block[place];
  }
  [[gnu::always_inline]] const PaddedMat<D>& of(const MatrixBlock<D>& of_block) const { return of_block.each[place]; }
  template <class T>
  [[gnu::always_inline]] void set(std::vector<T>& field, const auto& value) const {
    field[index] = value.template topRows<D>();
  }
  template <class T>
  [[gnu::always_inline]] void add(std::vector<T>& field, const auto& value) const {
    field[index] += value.template topRows<D>();
  }
};

/// The particles of a pack, for a node kernel. At its places without a particle of their own others are read, and
/// nothing is written.
template <int D>
class ParticlePack {
 public:
  [[gnu::always_inline]] ParticlePack(const PackList<D>& block, int pack)
      : particle_(&block.particle[pack * lanes]), place_(pack * lanes), count_(block.filled[pack]) {}

  int count() const { return count_; }
  std::size_t index(int lane) const { return particle_[lane]; }

  [[gnu::always_inline]] Pack of(const std::vector<double>& field) const {
    Pack pack;
    load_packs<1>(each<1>(field.data()), &pack);
    return pack;
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const std::vector<Eigen::Matrix<double, R, C>>& field) const {
    return loaded<R, C>(each<R * C>(field[0].data()));
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const Eigen::Matrix<double, R, C>* of_block) const {
    LaneAddresses<const double> from;
    for (int lane = 0; lane < lanes; ++lane) from[static_cast<std::size_t>(lane)] = of_block[place_ + lane].data();
    return loaded<R, C>(from);
  }
  [[gnu::always_inline]] PackMat<D> of(const MatrixBlock<D>& of_block) const {
    PackMat<D> packs;
    for (int c = 0; c < D; ++c)
      for (int r = 0; r < D; ++r) packs(r, c) = Pack(load_lanes(&of_block.entry[r][c][place_]));
    return packs;
  }

  template <int R, int C>
  [[gnu::always_inline]] void set(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    if (count_ == lanes)
      store_packs<R * C>(value.data(), each<R * C>(field[0].data()));
    else
      set_some(field, value);
  }
  template <int R, int C>
  [[gnu::always_inline]] void add(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    set(field, Eigen::Matrix<Pack, R, C>(of(field) + value));
  }

 private:
  /// Where the numbers of each are, so many to a particle.
  template <int n, class T>
  [[gnu::always_inline]] LaneAddresses<T> each(T* field) const {
    LaneAddresses<T> all;
    for (int lane = 0; lane < lanes; ++lane) all[static_cast<std::size_t>(lane)] = field + n * index(lane);
    return all;
  }
  template <int R, int C>
  [[gnu::always_inline]] static Eigen::Matrix<Pack, R, C> loaded(const LaneAddresses<const double>& from) {
    Eigen::Matrix<Pack, R, C> packs;
    load_packs<R * C>(from, packs.data());
    return packs;
  }
  template <int R, int C>
  [[gnu::noinline]] void set_some(std::vector<Eigen::Matrix<double, R, C>>& field,
                                  const Eigen::Matrix<Pack, R, C>& value) const {
    for (int lane = 0; lane < count_; ++lane)
      field[index(lane)] = value.unaryExpr([lane](const Pack& each) { return each[static_cast<std::size_t>(lane)]; });
  }

  const std::uint32_t* particle_;
  int place_;  ///< of the first, in the block
  int count_;
};

/// Calls visit(pack, k) for every pack of a block, the first of it at place k.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_packs(const PackList<D>& block, const Visit& visit) {
  for (int pack = 0; pack < block.packs; ++pack) visit(ParticlePack<D>(block, pack), pack * lanes);
}

}  // namespace mpmvv::solver
