#pragma once
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include "solver/stencils/kernel.hpp"

namespace mpmvv::solver {

/// Holds the kernels of a sweep that is to be made later, in order. The kernels are copied, but what they refer to has
/// to stay until then.
template <int D>
class WaitingSweep {
 public:
  WaitingSweep() { kernels_.reserve(most); }
  WaitingSweep(const WaitingSweep&) = delete;
  WaitingSweep& operator=(const WaitingSweep&) = delete;

  template <class... Kernels>
  void set(const Kernels&... kernels) {
    static_assert(sizeof...(Kernels) <= most && (std::is_trivially_destructible_v<Kernels> && ...));
    kernels_.clear();
    std::size_t used = 0;
    (keep(kernels, used), ...);
  }
  void clear() { kernels_.clear(); }
  bool empty() const { return kernels_.empty(); }
  std::span<const AnyKernel<D>> kernels() const { return kernels_; }

 private:
  static constexpr std::size_t most = 8, room = 128;  ///< the most kernels, and the bytes for each

  template <class Kernel>
  void keep(const Kernel& kernel, std::size_t& used) {
    static_assert(sizeof(Kernel) <= room && alignof(Kernel) <= alignof(std::max_align_t));
    kernels_.emplace_back(*new (&copies_[room * used++]) Kernel(kernel));
  }

  alignas(std::max_align_t) std::byte copies_[most * room];
  std::vector<AnyKernel<D>> kernels_;  ///< refer to the copies
};

}  // namespace mpmvv::solver
