// The heap of a process that takes and frees much memory again and again.
#ifndef TILEMEND_COMMON_UTIL_HEAP_H_
#define TILEMEND_COMMON_UTIL_HEAP_H_

namespace tilemend {

// Keeps freed memory for the next step in place of giving it back to the system, which would hand it out again page by
// page. Blocks of 32 MiB and more still come and go one by one. What is kept is kept for `threads` that work at once,
// at most as many as there are cores, and all the others together. Without effect where the C library is not glibc.
void KeepHeap(int threads);

// For a process of many threads of which few take much memory, each for a while. They share what is kept, at most 16
// MiB beyond what is in use. Blocks of 1 MiB and more are given back as soon as they are freed. Without effect where
// the C library is not glibc.
void ShareHeap();

// Gives freed memory back to the system after all: for when there is nothing more to do for a while.
void ReturnHeap();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_HEAP_H_
