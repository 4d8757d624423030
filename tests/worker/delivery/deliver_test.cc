#include "worker/delivery/deliver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

TEST(DeliverTest, AFormatWithLevelsGetsThemAll) {
  const std::string pack = OsgbScene().Pack(0);
  const auto all = DeliveryOf(pack, {"", "a.osgb", {}, ""}, "3dtiles");
  const auto finest = DeliveryOf(pack, {"", "a.osgb", {}, ""}, "obj");
  ASSERT_TRUE(all.ok()) << all.status();
  ASSERT_TRUE(finest.ok()) << finest.status();
  EXPECT_EQ(all->pieces.size(), 9U);
  EXPECT_EQ(finest->pieces.size(), 4U);
}

TEST(DeliverTest, VerticesOfATreeStayAsTheyAre) {
  EXPECT_EQ(DeliveryOrigin("a.osgb", {1000.4, 20.6}), Point3(0, 0, 0));
  EXPECT_EQ(DeliveryOrigin("a.obj", {1000.4, 20.6}), Point3(1000, 21, 0));
}

TEST(DeliverTest, EachFormatBeginsWithTheTilesOwnFile) {
  const std::string pack = OsgbScene().Pack(0);
  for (const auto& [format, own] :
       {std::pair("3dtiles", "a.json"), {"osgb", "a.osgb"}, {"obj", "a.obj"}, {"ply", "a.ply"}}) {
    auto tile = DeliveryOf(pack, {"", "a.osgb", {}, ""}, format);
    const auto files = Deliver(*tile, {.format = format, .stem = "a"});
    ASSERT_TRUE(files.ok()) << files.status();
    EXPECT_EQ(files->at(0).name, own);
  }
  DeliveryTile tile;
  EXPECT_TRUE(absl::IsInvalidArgument(Deliver(tile, {.format = "fbx", .stem = "a"}).status()));
}

}  // namespace
}  // namespace tilemend
