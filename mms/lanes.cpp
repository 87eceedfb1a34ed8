#include "mms/lanes.hpp"

#include <cstring>

namespace mpmvv::mms {

#if defined(__x86_64__) && defined(__AVX2__) && defined(__GLIBC__) && !defined(__UCLIBC__)

/// glibc's vector library. Its header declares these functions only for -ffast-math. Their error is at most four units
/// in the last place.
namespace libmvec {
using Double4 [[gnu::vector_size(32)]] = double;
Double4 sin(Double4 angles) asm("_ZGVdN4v_sin");
Double4 cos(Double4 angles) asm("_ZGVdN4v_cos");
}  // namespace libmvec

namespace {

Lanes by_four(libmvec::Double4 (*function)(libmvec::Double4), const Lanes& angles) {
  libmvec::Double4 fours[2];
  static_assert(sizeof(fours) == sizeof(Lanes));
  std::memcpy(fours, angles.data(), sizeof(fours));
  for (libmvec::Double4& four : fours) four = function(four);
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
