// The heap of a process that does one piece of work and ends.
#ifndef TILEMEND_COMMON_UTIL_HEAP_H_
#define TILEMEND_COMMON_UTIL_HEAP_H_

namespace tilemend {

// Keeps freed memory for the next step in place of giving it back to the system, which would hand it out again page by
// page. Blocks of 32 MiB and more still come and go one by one. Without effect where the C library is not glibc.
void KeepHeap();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_HEAP_H_
