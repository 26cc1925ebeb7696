#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace place_recognition {

/// Allocator for large tables with scattered access: requests pages of 2 MB from Linux, so that the
/// processor need not translate an address for every 4 kB it visits. Small tables get ordinary
/// pages.
template <typename T>
struct HugePages {
  using value_type = T;

  HugePages() = default;
  template <typename U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    constexpr std::size_t kPage = std::size_t{2} << 20;
    constexpr std::size_t kSmallPage = 4096;
    if (count > static_cast<std::size_t>(-1) / 4 / sizeof(T)) throw std::bad_alloc();
    const bool huge = count * sizeof(T) >= kPage;
    const std::size_t page = huge ? kPage : kSmallPage;
    const std::size_t bytes = (count * sizeof(T) + page - 1) / page * page;
    void* memory = std::aligned_alloc(page, bytes);
    if (!memory) throw std::bad_alloc();
#if defined(__linux__)
    if (huge) madvise(memory, bytes, MADV_HUGEPAGE);  // a hint: the result does not matter
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  /// Leaves numbers without a given value uninitialized, for callers that overwrite all of them.
  template <typename U>
  void construct(U* element) {
    ::new (static_cast<void*>(element)) U;
  }

  template <typename U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }
  template <typename U>
  bool operator!=(const HugePages<U>&) const {
    return false;
  }
};

/// HugeVector<T>(n) has n uninitialized numbers; HugeVector<T>(n, 0) has zeros.
template <typename T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace place_recognition
