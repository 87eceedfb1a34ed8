#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace mpmvv::solver {

/// Memory of an array. What fills whole huge pages (2 MiB) is asked for in such pages: a sweep over large arrays spends
/// less time on finding where its pages lie. Where the system has none to give, the memory is as any other.
template <class T>
struct HugePages {
  using value_type = T;

  static constexpr std::size_t page = std::size_t{1} << 21;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < page) return static_cast<T*>(::operator new(bytes, alignment));
    void* const memory = ::operator new (bytes, std::align_val_t{page});
    madvise(memory, bytes / page * page, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete (memory, count * sizeof(T) < page ? alignment : std::align_val_t{page});
  }

  template <class U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }

 private:
  static constexpr std::align_val_t alignment{alignof(T)};
};

/// One value for each particle or node.
template <class T>
using Array = std::vector<T, HugePages<T>>;

}  // namespace mpmvv::solver
