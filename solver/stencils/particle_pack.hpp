#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "solver/array.hpp"
#include "solver/simd/pack.hpp"
#include "solver/simd/padded.hpp"
#include "solver/stencils/block.hpp"

namespace mpmvv::solver {

/// Up to four consecutive particles, whose fields are read and written at once. If there are fewer than four, the last
/// particle takes the place of each missing one: it is read again, and written again.
struct ParticlePack {
  std::size_t first;
  int count;

  template <int R, int C>
  [[gnu::always_inline]] auto of(const Eigen::Matrix<double, R, C>* field) const {
    Eigen::Matrix<Pack, R, C> packs;
    if (R * C == 1 && count == 4)
      packs(0, 0).of = load4(field[first].data());
    else
      load_packs<R * C>(numbers<const double>(field), packs.data());
    return packs;
  }
  template <int R, int C>
  [[gnu::always_inline]] auto of(const Array<Eigen::Matrix<double, R, C>>& field) const {
    return of(field.data());
  }
  template <int R, int C>
  [[gnu::always_inline]] void write(const Eigen::Matrix<Pack, R, C>& packs, Eigen::Matrix<double, R, C>* field) const {
    if (R * C == 1 && count == 4)
      store4(packs(0, 0).of, field[first].data());
    else
      store_packs<R * C>(packs.data(), numbers<double>(field));
  }

 private:
  template <class Number>
  [[gnu::always_inline]] std::array<Number*, 4> numbers(auto* field) const {
    const auto of_lane = [&](int lane) {
      return field[first + static_cast<std::size_t>(count == 4 ? lane : std::min(lane, count - 1))].data();
    };
    return {of_lane(0), of_lane(1), of_lane(2), of_lane(3)};
  }
};

/// Returns the same particles with indices counted from `begin`.
[[gnu::always_inline]] inline ParticlePack operator-(const ParticlePack& p, std::size_t begin) {
  return {p.first - begin, p.count};
}

template <int D>
requires(D == 1) PackVec<2> padded(const PackVec<1>& vector, const Pack& last) {
  return {vector[0], last};
}

/// Returns the value of a field on a particle, or its values on four particles of a bar, where each is one number.
template <class T>
[[gnu::always_inline]] inline const T& read(const T* field, std::size_t p) {
  return field[p];
}
[[gnu::always_inline]] inline Pack read(const double* field, const ParticlePack& p) {
  return Pack(load4(field + p.first));
}
[[gnu::always_inline]] inline PackVec<1> read(const Eigen::Matrix<double, 1, 1>* field, const ParticlePack& p) {
  return PackVec<1>(read(field->data(), p));
}
template <class T>
[[gnu::always_inline]] inline decltype(auto) read(const Array<T>& field, const auto& p) {
  return read(field.data(), p);
}

/// field_p = value
template <class T>
[[gnu::always_inline]] inline void write(T value, T* field, std::size_t p) {
  field[p] = std::move(value);  // g++ would copy it through memory
}
[[gnu::always_inline]] inline void write(const PackVec<1>& value, Eigen::Matrix<double, 1, 1>* field,
                                         const ParticlePack& p) {
  store4(value[0].of, field[p.first].data());
}

/// field_p += value
template <class T>
[[gnu::always_inline]] inline void add(const auto& value, Array<T>& field, std::size_t p) {
  field[p] += value;
}
template <class T>
[[gnu::always_inline]] inline void add(const auto& value, Array<T>& field, const ParticlePack& p) {
  write(PackVec<1>(read(field, p) + value), field.data(), p);
}

/// Calls visit(pack, k) for every four particles of a block, and for those that remain; k is the place of the first of
/// them in the block.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_packs(const Block<D>& block, const Visit& visit) {
  int k = 0;
  const auto pack = [&](int count) { return ParticlePack{block.begin + static_cast<std::size_t>(k), count}; };
  for (; k + 4 <= block.count; k += 4) visit(pack(4), k);
  if (k < block.count) visit(pack(block.count - k), k);
}

}  // namespace mpmvv::solver
