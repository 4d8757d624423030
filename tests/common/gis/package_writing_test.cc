#include "common/gis/package_writing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::StartsWith;

TEST(PackageOfTest, TheSameFeaturesAreTheSameBytes) {
  const std::string text = CollectionText({FeatureText(PolygonText(SquareAt(0, 0, 4)))}, "urn:ogc:def:crs:EPSG::25832");
  const std::string package = PackageOf(text, "water");
  EXPECT_THAT(package, StartsWith("SQLite format 3"));
  EXPECT_EQ(PackageOf(text, "water"), package);
  EXPECT_NE(PackageOf(text, "lakes"), package);
}

TEST(PackageOfTest, WhatIsNoGeoJsonIsNothing) {
  EXPECT_EQ(PackageOf("", "water"), "");
  EXPECT_EQ(PackageOf("{}", "water"), "");
}

}  // namespace
}  // namespace tilemend
