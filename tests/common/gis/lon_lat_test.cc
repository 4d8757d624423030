#include "common/gis/lon_lat.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(LonLatTest, AZoneOfUtmHasItsMeridian) {
  const auto found = LonLatOf("EPSG:25832", {{500000, 5538630.703}, {500000, 0}});
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_NEAR((*found)[0].x(), 9, 1e-9);
  EXPECT_NEAR((*found)[0].y(), 50, 1e-6);
  EXPECT_NEAR((*found)[1].y(), 0, 1e-9);
}

TEST(LonLatTest, APlaneAtAPlaceIsKnown) {
  const auto found = LonLatOf("ENU:48.1,11.5", {{0, 0}, {0, 1000}});
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_NEAR((*found)[0].x(), 11.5, 1e-9);
  EXPECT_NEAR((*found)[0].y(), 48.1, 1e-9);
  EXPECT_NEAR((*found)[1].y(), 48.1 + 1000 / 111200.0, 1e-5);
}

TEST(LonLatTest, ACrsThatIsNotOfTilesInMetresIsRefused) {
  for (const char* crs : {"EPSG:2263", "EPSG:4978"}) {  // US survey feet; Earth-centred
    EXPECT_EQ(LonLatOf(crs, {{300000, 60000}}).status().code(), absl::StatusCode::kInvalidArgument) << crs;
  }
}

TEST(LonLatTest, AnUnknownCrsIsAnErrorWithItsName) {
  const auto found = LonLatOf("EPSG:no", {{0, 0}});
  EXPECT_EQ(found.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(found.status().message()), testing::HasSubstr("'EPSG:no'"));
  EXPECT_TRUE(LonLatOf("EPSG:no", {})->empty());
}

}  // namespace
}  // namespace tilemend
