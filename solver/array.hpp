#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace mpmvv::solver {

/// An allocator that asks the system for huge pages (2 MiB) where an array fills at least one: a sweep over large
/// arrays then misses the TLB, where the processor keeps the translation of addresses, less often. The system grants
/// them if /sys/kernel/mm/transparent_hugepage/enabled says `madvise` or `always`.
template <class T>
struct HugePages {
  using value_type = T;

  static constexpr std::size_t page = std::size_t{1} << 21;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < page) return std::allocator<T>().allocate(count);
    void* const memory = ::operator new (bytes, std::align_val_t{page});
    madvise(memory, bytes / page * page, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < page)
      std::allocator<T>().deallocate(memory, count);
    else
      ::operator delete (memory, std::align_val_t{page});
  }

  template <class U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }
};

/// A std::vector with this allocator: holds a field's value for each particle or node.
template <class T>
using Array = std::vector<T, HugePages<T>>;

/// Asks for a value that is soon read and written to be brought into the cache, and does not wait for it.
template <class T>
[[gnu::always_inline]] inline void prefetch(const T& value) {
  constexpr std::size_t cache_line = 64;
  const auto* const from = reinterpret_cast<const char*>(&value);
  __builtin_prefetch(from, 1);
  if constexpr (sizeof(T) > cache_line) __builtin_prefetch(from + sizeof(T) - 1, 1);
}

}  // namespace mpmvv::solver
