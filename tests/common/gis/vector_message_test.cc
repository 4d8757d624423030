#include "common/gis/vector_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

VectorFile SomeFile() {
  VectorFile file;
  VectorFeature& lake = file.features.emplace_back();
  lake.label = "feature 0";
  lake.polygon.rings = {{{0, 0}, {4, 0}, {4, 4}}, {{1, 1}, {2, 1}, {2, 2}}};
  lake.level = -0.5;
  lake.kind = WaterKind::kLake;
  lake.body = 7;
  lake.level_sigma = 0.125;
  lake.is_as_found = true;
  VectorFeature& line = file.features.emplace_back();
  line.line = {{1, 2}, {3, 4}};
  line.water = false;
  line.holes = {12, 14};
  line.decision = ReviewDecision::kOpen;
  file.coordinates = "EPSG:25832";
  file.warnings = {"one", ""};
  file.error = "none";
  return file;
}

TEST(VectorMessageTest, AFileComesBackAsItWas) {
  const VectorFile file = SomeFile();
  VectorFile read;
  ASSERT_TRUE(Decode(Encode(file), read));
  ASSERT_EQ(read.features.size(), 2U);
  EXPECT_EQ(read.features[0].label, "feature 0");
  EXPECT_EQ(read.features[0].polygon.rings, file.features[0].polygon.rings);
  EXPECT_EQ(read.features[0].level, -0.5);
  EXPECT_EQ(read.features[0].kind, WaterKind::kLake);
  EXPECT_EQ(read.features[0].body, 7);
  EXPECT_EQ(read.features[0].level_sigma, 0.125);
  EXPECT_TRUE(read.features[0].is_as_found);
  EXPECT_FALSE(read.features[1].is_as_found);
  EXPECT_EQ(read.features[1].line, file.features[1].line);
  EXPECT_FALSE(read.features[1].water);
  EXPECT_EQ(read.features[1].level, std::nullopt);
  EXPECT_EQ(read.features[1].holes, (std::vector<int64_t>{12, 14}));
  EXPECT_EQ(read.features[1].decision, ReviewDecision::kOpen);
  EXPECT_EQ(read.coordinates, file.coordinates);
  EXPECT_EQ(read.warnings, file.warnings);
  EXPECT_EQ(read.error, file.error);
}

TEST(VectorMessageTest, ARequestComesBackAsItWas) {
  VectorRequest request;
  request.format = VectorFormat::kArchive;
  request.opened = "polygons.zip";
  request.parts = {{"polygons.zip", std::string_view("\0bytes", 6)}, {"b", ""}};
  request.names_crs = false;
  request.features = 3;
  request.use = VectorUse::kDecisions;
  request.frame = {"EPSG:25832", {1, 2, 3}, {4, 5}, {6, 7}};
  const std::string bytes = Encode(request);
  VectorRequest read;
  ASSERT_TRUE(Decode(bytes, read));
  EXPECT_EQ(read.format, VectorFormat::kArchive);
  EXPECT_EQ(read.opened, request.opened);
  ASSERT_EQ(read.parts.size(), 2U);
  EXPECT_EQ(read.parts[0].bytes, request.parts[0].bytes);
  EXPECT_FALSE(read.names_crs);
  EXPECT_EQ(read.features, 3);
  EXPECT_EQ(read.use, VectorUse::kDecisions);
  EXPECT_EQ(read.frame.crs, "EPSG:25832");
  EXPECT_EQ(read.frame.origin, Point3(1, 2, 3));
  EXPECT_EQ(read.frame.hi, Point2(6, 7));
}

TEST(VectorMessageTest, OtherBytesAreRefused) {
  const std::string bytes = Encode(SomeFile());
  VectorFile read;
  for (size_t size = 0; size < bytes.size(); ++size) {
    read = {};
    EXPECT_FALSE(Decode(bytes.substr(0, size), read)) << size;
  }
  EXPECT_FALSE(Decode(bytes + "x", read));
  EXPECT_FALSE(Decode(std::string(64, '\xff'), read));
}

TEST(VectorMessageTest, ChangedBytesDoNoHarm) {
  const std::string bytes = Encode(SomeFile());
  for (size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x40);
    VectorFile read;
    if (!Decode(changed, read)) continue;
    EXPECT_LT(read.features.size(), 100U);
  }
}

}  // namespace
}  // namespace tilemend
