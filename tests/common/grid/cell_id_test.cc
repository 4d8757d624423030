#include <gtest/gtest.h>

#include <set>

#include "common/grid/scene.h"

namespace tilemend {
namespace {

TEST(CellIdTest, IsWrittenAsInTileNames) {
  EXPECT_EQ(ToString({3, 1}), "+003_+001");
  EXPECT_EQ(ToString({-2, 1234}), "-002_+1234");
  EXPECT_EQ(ToString({0, 0}), "+000_+000");
  EXPECT_EQ(ToString({-100000, 2147483647}), "-100000_+2147483647");
}

TEST(CellIdTest, IsOrderedByColumnThenRow) {
  const std::set<CellId> cells = {{1, 0}, {0, 1}, {-1, 5}, {0, 0}};
  EXPECT_EQ(std::vector<CellId>(cells.begin(), cells.end()), (std::vector<CellId>{{-1, 5}, {0, 0}, {0, 1}, {1, 0}}));
}

}  // namespace
}  // namespace tilemend
