#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace place_recognition {

unsigned threadCount(unsigned requested) {
  return requested > 0 ? requested : std::max(1u, std::thread::hardware_concurrency());
}

void parallelFor(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t, unsigned)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const auto run = [&](unsigned thread) {
    try {
      for (std::size_t i; (i = next++) < count;) work(i, thread);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };

  const std::size_t wanted = std::min<std::size_t>(threadCount(threads), count);
  std::vector<std::thread> helpers;
  try {
    for (std::size_t thread = 1; thread < wanted; ++thread) helpers.emplace_back(run, thread);
  } catch (const std::system_error&) {  // the system gives no more threads: these do all the work
  }
  run(0);
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace place_recognition
