#pragma once

#include <cstddef>
#include <functional>

namespace place_recognition {

/// How many threads `requested` means: itself, or the number of cores if it is 0.
unsigned threadCount(unsigned requested);

/// Calls `work(i, thread)` for every i in 0..count-1, each once, in no fixed order, from at most
/// `threads` threads (0: one per core); `thread` tells them apart, 0..threads-1. The first
/// exception stops the rest and is thrown again here.
void parallelFor(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t i, unsigned thread)>& work);

}  // namespace place_recognition
