#include "common/codec/gltf/gltf_draco.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

// The stream in a sample, which lies behind the image.
std::string Stream(bool is_edgebreaker) {
  const GltfSample sample = DracoSample(is_edgebreaker);
  const auto& view = sample.json["bufferViews"][1];
  return sample.bin.substr(view["byteOffset"].get<size_t>(), view["byteLength"].get<size_t>());
}

TEST(GltfDracoTest, DecodesBothMethods) {
  for (const bool is_edgebreaker : {false, true}) {
    const absl::StatusOr<GltfDracoMesh> mesh = DecodeGltfDraco(Stream(is_edgebreaker));
    ASSERT_TRUE(mesh.ok()) << mesh.status();
    EXPECT_EQ(mesh->points, 25);
    EXPECT_EQ(mesh->faces.size(), 32u);
    ASSERT_EQ(mesh->attributes.size(), 2u);
    EXPECT_EQ(mesh->attributes[0].component_type, 5126);
    EXPECT_EQ(mesh->attributes[0].components, 3);
    EXPECT_EQ(mesh->attributes[0].values.size(), 25u * 12);
    EXPECT_EQ(mesh->attributes[1].id, 1u);
    EXPECT_EQ(mesh->attributes[1].values.size(), 25u * 8);
    float highest = 0;
    for (size_t i = 0; i < 25; ++i) {
      float x = 0;
      std::memcpy(&x, mesh->attributes[0].values.data() + 12 * i, sizeof(x));
      highest = std::max(highest, x);
    }
    EXPECT_NEAR(highest, 4, 1e-3);
  }
}

TEST(GltfDracoTest, HoldsCountsAgainstLimits) {
  EXPECT_EQ(DecodeGltfDraco(Stream(true), {.max_points = 24}).status().code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(DecodeGltfDraco(Stream(true), {.max_faces = 31}).status().code(), absl::StatusCode::kResourceExhausted);
}

// Header, faces, points: a few bytes that claim 2^32 - 1 points.
TEST(GltfDracoTest, RefusesMoreThanTheStreamCanHold) {
  const std::string many("\xff\xff\xff\xff\x0f", 5);
  const absl::Status sequential =
      DecodeGltfDraco(std::string("DRACO\2\2\1\0\0\0\1", 12) + many + std::string(40, '\0')).status();
  EXPECT_EQ(sequential.code(), absl::StatusCode::kResourceExhausted) << sequential;
  const absl::Status edgebreaker =
      DecodeGltfDraco(std::string("DRACO\2\2\1\1\0\0\0\3", 13) + many + std::string(40, '\0')).status();
  EXPECT_EQ(edgebreaker.code(), absl::StatusCode::kResourceExhausted) << edgebreaker;
}

TEST(GltfDracoTest, RefusesOtherStreams) {
  const auto message = [](std::string_view stream) { return std::string(DecodeGltfDraco(stream).status().message()); };
  EXPECT_EQ(message(""), "Draco stream: expected a mesh of version 2.2");
  EXPECT_EQ(message(std::string("DRACO\1\1\1\0\0\0", 11)), "Draco stream: expected a mesh of version 2.2");
  EXPECT_EQ(message(std::string("DRACO\2\2\1\2\0\0", 11)), "Draco stream: unknown method");
  EXPECT_EQ(message(std::string("DRACO\2\2\1\1\0\x80", 11)), "Draco stream: metadata is not read");
  EXPECT_EQ(message(std::string("DRACO\2\2\1\1\0\0\0", 12)), "Draco stream: the header is cut off");
  EXPECT_EQ(message(std::string("DRACO\2\2\1\1\0\0\0\3\3\x11\0\0", 17)), "Draco stream: more than 16 attributes");
}

TEST(GltfDracoTest, RefusesEveryCut) {
  for (const bool is_edgebreaker : {false, true}) {
    const std::string stream = Stream(is_edgebreaker);
    for (size_t size = 0; size < stream.size(); ++size) {
      EXPECT_FALSE(DecodeGltfDraco(std::string(stream, 0, size)).ok()) << size;
    }
  }
}

}  // namespace
}  // namespace tilemend
