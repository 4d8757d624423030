#include "coordinator/waves/tile_writes.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(TileWritesTest, GivesEachTileOnce) {
  TileWrites writes;
  EXPECT_TRUE(writes.Queue({1, 2}));
  EXPECT_FALSE(writes.Queue({1, 2}));
  writes.Dismiss({3, 3});
  writes.Dismiss({1, 2});  // it is to be written
  EXPECT_EQ(writes.cells_done(), 1);
  EXPECT_FALSE(writes.Queue({3, 3}));
  EXPECT_EQ(writes.Next(0, false), (CellId{1, 2}));
  EXPECT_EQ(writes.Next(0, false), std::nullopt);
}

TEST(TileWritesTest, GivesAsManyAsThereIsOtherWorkOut) {
  TileWrites writes;
  for (int32_t row = 0; row < 5; ++row) writes.Queue({0, row});
  EXPECT_EQ(writes.Next(0, true), std::nullopt);  // the others begin
  EXPECT_EQ(writes.Next(1, true), (CellId{0, 0}));
  EXPECT_EQ(writes.Next(1, false), std::nullopt);
  EXPECT_EQ(writes.Next(2, false), (CellId{0, 1}));
  writes.Settle(true);
  EXPECT_EQ(writes.Next(2, false), (CellId{0, 2}));
  EXPECT_EQ(writes.Next(0, false), (CellId{0, 3}));  // nothing else is left
  EXPECT_EQ(writes.Next(0, false), (CellId{0, 4}));
}

TEST(TileWritesTest, IsOverWhenAllResultsAreThere) {
  TileWrites writes;
  EXPECT_TRUE(writes.is_over());
  writes.Queue({0, 0});
  EXPECT_FALSE(writes.is_over());
  writes.Next(0, false);
  EXPECT_FALSE(writes.is_over());
  writes.Settle(false);
  EXPECT_TRUE(writes.is_over());
  EXPECT_EQ(writes.cells_done(), 0);
}

}  // namespace
}  // namespace tilemend
