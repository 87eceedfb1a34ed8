#include "mms/lanes.hpp"

#include <cstring>

namespace mpmvv::mms {

#if defined(__x86_64__) && defined(__AVX2__) && defined(__GLIBC__) && !defined(__UCLIBC__)

/// glibc's vector library, whose header declares these for -ffast-math alone: four units in the last place at most.
namespace libmvec {
using Four [[gnu::vector_size(32)]] = double;
Four sin(Four angles) asm("_ZGVdN4v_sin");
Four cos(Four angles) asm("_ZGVdN4v_cos");
}  // namespace libmvec

namespace {

Lanes by_four(libmvec::Four (*function)(libmvec::Four), const Lanes& angles) {
  libmvec::Four fours[2];
  static_assert(sizeof(fours) == sizeof(Lanes));
  std::memcpy(fours, angles.data(), sizeof(fours));
  for (libmvec::Four& four : fours) four = function(four);
  return Lanes(reinterpret_cast<const double*>(fours));
}

}  // namespace

Lanes sin(const Lanes& angles) {
  return by_four(libmvec::sin, angles);
}

Lanes cos(const Lanes& angles) {
  return by_four(libmvec::cos, angles);
}

#else

Lanes sin(const Lanes& angles) {
  return angles.sin();
}

Lanes cos(const Lanes& angles) {
  return angles.cos();
}

#endif

}  // namespace mpmvv::mms
