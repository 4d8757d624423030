#include "common/records/surface.h"

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

namespace tilemend {
namespace {

TEST(SurfaceTest, EachIsFoundByItsName) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    EXPECT_EQ(SurfaceNamed(SurfaceName(surface)), surface) << SurfaceName(surface);
  }
}

// Flags, stored jobs and reports hold these texts.
TEST(SurfaceTest, NamesStayAsUsersAndStoredJobsKnowThem) {
  EXPECT_STREQ(SurfaceName(Surface::kThinPlate), "thin-plate");
  EXPECT_STREQ(SurfaceName(Surface::kWang), "wang");
  EXPECT_STREQ(SurfaceName(kDefaultSurface), "thin-plate");
}

TEST(SeamPointsTest, ReadsBackItsNamesAndNoOthers) {
  for (const SeamPoints points : {SeamPoints::kProjected, SeamPoints::kSpaced}) {
    EXPECT_EQ(SeamPointsNamed(SeamPointsName(points)), points);
  }
  EXPECT_STREQ(SeamPointsName(SeamPoints::kProjected), "projected");
  EXPECT_EQ(SeamPointsNamed("even"), std::nullopt);
}

TEST(ClosureTest, ReadsBackItsNamesAndNoOthers) {
  for (const Closure closure : {Closure::kBuffers, Closure::kLine})
    EXPECT_EQ(ClosureNamed(ClosureName(closure)), closure);
  EXPECT_STREQ(ClosureName(Closure::kBuffers), "buffers");
  EXPECT_STREQ(ClosureName(Closure::kLine), "line");
  EXPECT_EQ(ClosureNamed("lines"), std::nullopt);
}

TEST(SurfaceTest, NoOtherTextNamesOne) {
  for (const std::string_view text : {"", "flat", "Wang", "wang ", " wang", "thin", "thin-plate-2", "thin_plate"}) {
    EXPECT_EQ(SurfaceNamed(text), std::nullopt) << '"' << text << '"';
  }
}

}  // namespace
}  // namespace tilemend
