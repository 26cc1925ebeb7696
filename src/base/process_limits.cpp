#include "base/process_limits.h"

#include <sys/resource.h>

namespace place_recognition {

void limitMemory() {
// Sanitizers reserve terabytes of address space.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const rlimit memory{kMaxMemory, kMaxMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

void limitProcess(unsigned seconds) {
  limitMemory();
  const rlimit time{seconds, seconds};
  setrlimit(RLIMIT_CPU, &time);
}

}  // namespace place_recognition
