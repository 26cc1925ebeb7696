#pragma once

#include <cstddef>
#include <functional>

namespace place_recognition {

/// Number of threads that `requested` stands for: itself, or the number of cores if it is 0.
unsigned threadCount(unsigned requested);

/// Calls `work(i, thread)` once for every i in 0..count-1, in no fixed order, from at most
/// `threads` threads (0: one per core); `thread`, 0..threads-1, identifies the thread. The first
/// exception stops the rest and is rethrown here.
void parallelFor(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t i, unsigned thread)>& work);

}  // namespace place_recognition
