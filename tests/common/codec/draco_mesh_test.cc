#include "common/codec/draco_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "common/codec/draco_frame.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

LatticeMesh RandomMesh(int points, int triangles, int32_t range) {
  std::mt19937 random(7);
  LatticeMesh mesh;
  const auto coordinate = [&] { return static_cast<int32_t>(random() % (2 * uint32_t(range) + 1)) - range; };
  for (int i = 0; i < points; ++i) mesh.points.push_back({coordinate(), coordinate(), coordinate()});
  const auto corner = [&] { return static_cast<int32_t>(random() % static_cast<uint32_t>(points)); };
  for (int i = 0; i < triangles; ++i) mesh.triangles.push_back({corner(), corner(), corner()});
  return mesh;
}

void ExpectRoundTrip(const LatticeMesh& mesh) {
  const std::string bytes = EncodeDraco(mesh);
  const auto back = DecodeDraco(bytes, {});
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->points, mesh.points);
  EXPECT_EQ(back->triangles, mesh.triangles);
  EXPECT_EQ(EncodeDraco(*back), bytes);
}

TEST(DracoMeshTest, KeepsPointsAndTrianglesInOrder) {
  for (const int points : {1, 2, 3, 100, 255, 256, 257, 65535, 65536, 70000}) {
    SCOPED_TRACE(points);
    ExpectRoundTrip(RandomMesh(points, 2 * points, 1 << 20));
  }
}

TEST(DracoMeshTest, TakesAnyTopology) {
  ExpectRoundTrip({});
  ExpectRoundTrip(RandomMesh(1, 0, 10));
  ExpectRoundTrip(RandomMesh(50, 0, 10));
  ExpectRoundTrip(
      {.points = std::vector<std::array<int32_t, 3>>(20, {5, 5, 5}), .triangles = {{0, 0, 0}, {1, 2, 3}, {1, 2, 3}}});
}

TEST(DracoMeshTest, TakesTheWholeRangeOfIntegers) {
  constexpr int32_t kLeast = std::numeric_limits<int32_t>::min();
  constexpr int32_t kMost = std::numeric_limits<int32_t>::max();
  ExpectRoundTrip({.points = {{kLeast, kMost, 0}, {kMost, kLeast, -1}, {0, 0, kLeast}}, .triangles = {{0, 1, 2}}});
  ExpectRoundTrip(RandomMesh(1000, 1000, kMost / 4 - 1));
}

TEST(DracoMeshTest, UsesDracoForACellFarFromZero) {
  LatticeMesh mesh = RandomMesh(1000, 1000, 1 << 17);
  for (auto& point : mesh.points) point = {point[0] + 1'000'000'000, point[1] - 2'000'000'000, point[2]};
  ExpectRoundTrip(mesh);
  EXPECT_EQ(UnwrapFrame(EncodeDraco(mesh))->content, FrameContent::kDraco);
}

TEST(DracoMeshTest, RefusesMoreThanTheLimits) {
  for (const int points : {100, 0}) {
    const std::string bytes =
        EncodeDraco(points == 0 ? LatticeMesh{{{1, 2, 3}}, {{0, 0, 0}}} : RandomMesh(points, 50, 9));
    EXPECT_EQ(DecodeDraco(bytes, {.max_points = 0}).status().code(), absl::StatusCode::kResourceExhausted);
    EXPECT_EQ(DecodeDraco(bytes, {.max_triangles = 0}).status().code(), absl::StatusCode::kResourceExhausted);
  }
}

TEST(DracoMeshTest, RefusesEveryDamagedByteAndLength) {
  const std::string good = EncodeDraco(RandomMesh(30, 40, 1000));
  for (size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    EXPECT_EQ(DecodeDraco(bad, {}).status().code(), absl::StatusCode::kInvalidArgument) << i;
    EXPECT_FALSE(DecodeDraco(good.substr(0, i), {}).ok()) << i;
  }
  EXPECT_FALSE(DecodeDraco(good + "x", {}).ok());
}

}  // namespace
}  // namespace tilemend
