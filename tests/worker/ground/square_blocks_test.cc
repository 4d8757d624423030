#include "worker/ground/square_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Stretch = std::array<int32_t, 3>;  // row, first column, end

std::vector<Stretch> RunsOf(const SquareBlocks& set) {
  std::vector<Stretch> runs;
  set.ForRuns([&](int32_t row, int32_t first, int32_t end) { runs.push_back({row, first, end}); });
  return runs;
}

TEST(SquareBlocksTest, HasTheBlocksOfItsSquaresUpToTheRastersEnd) {
  SquareBlocks set(19, 9);
  EXPECT_THAT(RunsOf(set), IsEmpty());
  set.Add(0, 8);
  set.Add(18, 8);
  EXPECT_THAT(RunsOf(set), ElementsAre(Stretch{8, 0, 8}, Stretch{8, 16, 19}));
  set.Add(9, 8);
  EXPECT_THAT(RunsOf(set), ElementsAre(Stretch{8, 0, 19}));
}

TEST(SquareBlocksTest, AllIsEachSquareOnce) {
  EXPECT_THAT(RunsOf(SquareBlocks::All(13, 2)), ElementsAre(Stretch{0, 0, 13}, Stretch{1, 0, 13}));
  EXPECT_THAT(RunsOf(SquareBlocks::All(0, 0)), IsEmpty());
}

TEST(SquareBlocksTest, GrowsByWholeBlocksAlongBothAxes) {
  SquareBlocks set(64, 40);
  set.Add(32, 17);
  for (const auto& [squares, first, end, rows] : std::vector<std::array<int32_t, 4>>{
           {0, 32, 40, 8}, {1, 24, 48, 24}, {8, 24, 48, 24}, {9, 16, 56, 40}, {100, 0, 64, 40}}) {
    const std::vector<Stretch> runs = RunsOf(set.GrownBy(squares));
    EXPECT_EQ(std::ssize(runs), rows) << squares;
    for (const Stretch& run : runs) EXPECT_THAT((std::array{run[1], run[2]}), ElementsAre(first, end)) << squares;
  }
}

}  // namespace
}  // namespace tilemend
