#include "common/util/heap.h"

#include <algorithm>
#include <limits>  // and with it, whether this is glibc
#include <thread>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tilemend {

void KeepHeap([[maybe_unused]] int threads) {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 1 << 20);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  mallopt(M_ARENA_MAX, std::min(threads, cores) + 1);
#endif
}

void ShareHeap() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);   // or it grows with what is freed
  mallopt(M_TRIM_THRESHOLD, 16 << 20);  // or each large step takes its memory from the system anew, page by page
  mallopt(M_ARENA_MAX, 2);
#endif
}

void ReturnHeap() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace tilemend
