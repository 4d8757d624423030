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

std::string MessageOf(const std::string& stream) {
  const auto mesh = DecodeDraco(WrapFrame(FrameContent::kDraco, std::string(12, '\0') + stream), {});
  EXPECT_FALSE(mesh.ok());
  return std::string(mesh.status().message());
}

// A peer that computes the checksum right still does not get past the guard.
TEST(DracoMeshTest, GuardsDracoFromForgedStreams) {
  const std::string bytes = EncodeDraco(RandomMesh(30, 40, 1000));
  const std::string payload(UnwrapFrame(bytes)->payload);
  const std::string good = payload.substr(12);  // behind the least corner
  ASSERT_TRUE(DecodeDraco(WrapFrame(FrameContent::kDraco, payload), {}).ok());
  const auto with = [&good](size_t at, const std::string& text) {
    return std::string(good).replace(at, text.size(), text);
  };
  EXPECT_THAT(MessageOf(with(7, std::string(1, '\0'))),
              HasSubstr("byte 0: expected a sequential Draco mesh without metadata"));
  EXPECT_THAT(MessageOf(with(8, "\1")), HasSubstr("expected a sequential Draco mesh"));     // edgebreaker
  EXPECT_THAT(MessageOf(with(10, "\x80")), HasSubstr("expected a sequential Draco mesh"));  // metadata
  EXPECT_THAT(MessageOf(with(11, "\xff\xff\xff\xff\x0f")), HasSubstr("are more than"));     // triangles
  EXPECT_THAT(MessageOf(with(11, "\xff\xff\xff\xff\xff")), HasSubstr("the number of triangles"));
  EXPECT_THAT(MessageOf(with(12, "\xff\xff\xff\xff\x0f")), HasSubstr("are more than"));  // points
  EXPECT_THAT(MessageOf(with(13, std::string(1, '\0'))), HasSubstr("plain indices"));
  EXPECT_THAT(MessageOf(with(14, "\x1e")),
              HasSubstr("the decoded mesh is not what its header says"));  // index 30 of 30 points
  EXPECT_THAT(MessageOf(with(14 + 120, "\2")), HasSubstr("one attribute decoder"));
  EXPECT_THAT(MessageOf(with(14 + 121, "\x7f")), HasSubstr("one attribute"));
  EXPECT_THAT(MessageOf(with(14 + 124, "\xff")), HasSubstr("three components"));
  EXPECT_THAT(MessageOf(good.substr(0, 20)), HasSubstr("the indices of the triangles"));
}

}  // namespace
}  // namespace tilemend
