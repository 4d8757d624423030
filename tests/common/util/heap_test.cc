#include "common/util/heap.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>

namespace tilemend {
namespace {

// First: what is kept by then is used first.
TEST(HeapTest, GivesLargeBlocksBackWhereItIsShared) {
  ShareHeap();
  constexpr size_t kBytes = size_t{1} << 20;
  for (int i = 0; i < 2; ++i) {  // the second would come from what is kept
    const size_t before = mallinfo2().hblkhd;
    void* volatile block = std::malloc(kBytes);
    EXPECT_GE(mallinfo2().hblkhd, before + kBytes);
    std::free(block);
    EXPECT_EQ(mallinfo2().hblkhd, before);
  }
}

// Else each step takes its memory from the system anew.
TEST(HeapTest, KeepsSomeOfTheSmallBlocksWhereItIsShared) {
  ShareHeap();
  std::array<void*, 64> blocks{};
  for (void*& block : blocks) block = std::malloc(size_t{128} << 10);
  const size_t before = mallinfo2().arena;
  for (void* const block : blocks) std::free(block);
  EXPECT_EQ(mallinfo2().arena, before);
  ReturnHeap();  // what is kept would be used by the other tests
}

TEST(HeapTest, KeepsWhatIsFreed) {
  KeepHeap(1);
  constexpr size_t kBytes = size_t{16} << 20;
  const size_t before = mallinfo2().arena;
  void* volatile block = std::malloc(kBytes);  // or the compiler leaves both calls out
  std::free(block);
  EXPECT_GE(mallinfo2().arena, before + kBytes);
}

TEST(HeapTest, ReturnsWhatIsFreedWhenAsked) {
  KeepHeap(1);
  constexpr size_t kBytes = size_t{16} << 20;
  void* volatile block = std::malloc(kBytes);
  std::free(block);
  const size_t kept = mallinfo2().keepcost;
  EXPECT_GE(kept, kBytes);
  ReturnHeap();
  EXPECT_LT(mallinfo2().keepcost, kept);
}

}  // namespace
}  // namespace tilemend
#endif
