#include "reliability/allocation_meter.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cerrno>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLACE_RECOGNITION_SANITIZED
// The sanitizers' functions. g++ does not ship their header, sanitizer/allocator_interface.h.
extern "C" {
int __sanitizer_install_malloc_and_free_hooks(void (*on_taken)(const volatile void*, std::size_t),
                                              void (*on_given)(const volatile void*));
std::size_t __sanitizer_get_allocated_size(const volatile void* memory);
}
#endif

namespace {

std::atomic<bool> watching{false};
std::atomic<long long> held{0}, peak_held{0}, largest_request{0};

void taken(std::size_t bytes) {
  if (!watching) return;
  const auto amount = static_cast<long long>(bytes);
  const long long now = held += amount;
  peak_held = std::max(peak_held.load(), now);
  largest_request = std::max(largest_request.load(), amount);
}

void given(std::size_t bytes) {
  if (watching) held -= static_cast<long long>(bytes);
}

}  // namespace

#ifdef PLACE_RECOGNITION_SANITIZED

namespace {

void onTaken(const volatile void*, std::size_t bytes) { taken(bytes); }

void onGiven(const volatile void* memory) {
  if (memory) given(__sanitizer_get_allocated_size(memory));
}

const int installed = __sanitizer_install_malloc_and_free_hooks(onTaken, onGiven);

}  // namespace

#else  // Our functions override those of the C library, which they call.

extern "C" {

void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void* memory);

void* malloc(std::size_t bytes) {
  void* memory = __libc_malloc(bytes);
  if (memory) taken(malloc_usable_size(memory));
  return memory;
}

void* calloc(std::size_t count, std::size_t bytes) {
  void* memory = __libc_calloc(count, bytes);
  if (memory) taken(malloc_usable_size(memory));
  return memory;
}

void* realloc(void* memory, std::size_t bytes) {
  const std::size_t before = memory ? malloc_usable_size(memory) : 0;
  void* moved = __libc_realloc(memory, bytes);
  if (moved || bytes == 0) given(before);
  if (moved) taken(malloc_usable_size(moved));
  return moved;
}

void* memalign(std::size_t alignment, std::size_t bytes) {
  void* memory = __libc_memalign(alignment, bytes);
  if (memory) taken(malloc_usable_size(memory));
  return memory;
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }

int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  *memory = memalign(alignment, bytes);
  return *memory ? 0 : ENOMEM;
}

void free(void* memory) {
  if (memory) given(malloc_usable_size(memory));
  __libc_free(memory);
}

}  // extern "C"

#endif

namespace place_recognition {

AllocationMeter::AllocationMeter() {
  held = peak_held = largest_request = 0;
  watching = true;
}

AllocationMeter::~AllocationMeter() { watching = false; }

std::size_t AllocationMeter::largest() const { return static_cast<std::size_t>(largest_request); }

std::size_t AllocationMeter::peak() const { return static_cast<std::size_t>(peak_held); }

}  // namespace place_recognition
