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

}  // namespace mpmvv::solver
