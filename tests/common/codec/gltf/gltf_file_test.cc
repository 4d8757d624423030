#include "common/codec/gltf/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/gltf/gltf_checks.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(GltfFileTest, AppliesMatricesAndTheAxis) {
  const GltfFile file = ReadGltfSample(SquareSample().Glb());
  // 2 * ((10, 20, 30) + point), then y up to z up.
  EXPECT_THAT(file.points,
              ElementsAre(Point3(20, -60, 40), Point3(24, -60, 40), Point3(24, -56, 42), Point3(20, -56, 40)));
  EXPECT_THAT(file.uv, ElementsAre(std::array<float, 2>{0, 0}, std::array<float, 2>{1, 0}, std::array<float, 2>{1, 1},
                                   std::array<float, 2>{0, 1}));
  ASSERT_EQ(file.primitives.size(), 1u);
  EXPECT_EQ(file.primitives[0].texture, 0);
  EXPECT_EQ(file.primitives[0].triangle_count, 2);
  EXPECT_EQ(ReadGltfSample(SquareSample().Glb(), GltfUpAxis::kZ).points[0], Point3(20, 40, 60));
}

TEST(GltfFileTest, TellsWhereImagesLie) {
  const std::string bytes = SquareSample().Glb();
  const GltfFile file = ReadGltfSample(bytes);
  ASSERT_EQ(file.images.size(), 1u);
  EXPECT_EQ(bytes.substr(file.images[0].offset, file.images[0].size), OnePixelPng());
  EXPECT_EQ(file.images[0].mime_type, "image/png");
  EXPECT_EQ(file.images[0].name, "photo");
}

TEST(GltfFileTest, NeverOpensImagesInOtherFiles) {
  GltfSample sample = SquareSample();
  sample.json["images"][0] = {{"uri", "../../etc/passwd"}};
  const GltfFile file = ReadGltfSample(sample.Glb());
  EXPECT_EQ(file.images[0].name, "../../etc/passwd");
  EXPECT_EQ(file.images[0].size, 0u);
}

TEST(GltfFileTest, TellsTheOriginApart) {
  const auto files = GltfSampleFiles();
  const GltfFile file = ReadGltfSample(files.back().second);
  EXPECT_TRUE(file.is_b3dm);
  EXPECT_EQ(file.origin, Point3(1000.5, -2000.25, 3000));
  EXPECT_EQ(file.points, ReadGltfSample(SquareSample().Glb()).points);
}

TEST(GltfFileTest, DequantizesPositionsAndTextureCoordinates) {
  const GltfFile file = ReadGltfSample(QuantizedSample().Glb());
  EXPECT_EQ(file.points[2], Point3(600, 200, 205));
  EXPECT_EQ(file.uv[2], (std::array<float, 2>{1, 0.75F}));  // (1, 0), halved and moved by (0.5, 0.25); v up
}

TEST(GltfFileTest, ReadsCompressedGridsAsThePlainOne) {
  const GltfFile plain = ReadGltfSample(GridSample().Glb());
  const GltfFile meshopt = ReadGltfSample(MeshoptSample().Glb());
  EXPECT_EQ(meshopt.points, plain.points);
  EXPECT_EQ(meshopt.uv, plain.uv);
  for (const bool is_edgebreaker : {false, true}) {
    const GltfFile draco = ReadGltfSample(DracoSample(is_edgebreaker).Glb());
    EXPECT_TRUE(draco.primitives[0].is_draco);
    EXPECT_EQ(draco.triangles.size(), plain.triangles.size());
    for (const Point3& point : draco.points) {
      const bool is_near =
          std::ranges::any_of(plain.points, [&](const Point3& p) { return (p - point).norm() < 1e-3; });
      EXPECT_TRUE(is_near) << point.transpose();
    }
  }
}

TEST(GltfFileTest, TurnsMirroredTrianglesRound) {
  GltfSample sample = SquareSample();
  sample.json["nodes"][0]["scale"] = {-2, 2, 2};
  EXPECT_THAT(ReadGltfSample(sample.Glb()).triangles, ElementsAre(Triangle{0, 2, 1}, Triangle{0, 3, 2}));
}

TEST(GltfFileTest, LimitsWhatIsDrawn) {
  const std::string bytes = SquareSample().Glb();
  EXPECT_EQ(ReadGltf(bytes, GltfUpAxis::kY, "a", {.max_points = 3}).status().code(),
            absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(ReadGltf(bytes, GltfUpAxis::kY, "a", {.max_triangles = 1}).status().code(),
            absl::StatusCode::kResourceExhausted);
}

TEST(GltfFileTest, RefusesPositionsThatAreNotFinite) {
  GltfSample sample = SquareSample();
  const auto at = sample.json["bufferViews"][1]["byteOffset"].get<size_t>();
  sample.bin.replace(at, 4, std::string("\0\0\x80\x7f", 4));  // infinity
  EXPECT_THAT(GltfRefusal(sample.Glb()), HasSubstr("vertex 0 is not finite"));
}

}  // namespace
}  // namespace tilemend
