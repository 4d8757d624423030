#include "common/codec/gltf/gltf_container.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

std::string Message(std::string_view bytes) {
  return std::string(ParseGltfContainer(bytes, "a.glb").status().message());
}

std::string WithNumber(std::string bytes, size_t at, uint32_t value) {
  std::memcpy(bytes.data() + at, &value, sizeof(value));
  return bytes;
}

TEST(GltfContainerTest, ReadsChunks) {
  const std::string bytes = GlbOf(R"({"asset":{}})", "12345");
  const absl::StatusOr<GltfContainer> container = ParseGltfContainer(bytes, "a.glb");
  ASSERT_TRUE(container.ok()) << container.status();
  EXPECT_FALSE(container->is_b3dm);
  EXPECT_EQ(container->bin, std::string_view("12345\0\0\0", 8));
  EXPECT_EQ(container->bin_offset, bytes.size() - 8);
  EXPECT_EQ(container->json.dump(), R"({"asset":{}})");
}

TEST(GltfContainerTest, ReadsTheCentreOfAB3dm) {
  const std::string glb = GlbOf("{}", "");
  const std::string bytes = B3dmOf(glb, R"({"RTC_CENTER":[1,2,3.5]})", R"({"n":["x"]})");
  const absl::StatusOr<GltfContainer> container = ParseGltfContainer(bytes, "a.b3dm");
  ASSERT_TRUE(container.ok()) << container.status();
  EXPECT_TRUE(container->is_b3dm);
  EXPECT_EQ(container->origin, Point3(1, 2, 3.5));
  EXPECT_THAT(std::string(container->head), HasSubstr(R"({"n":["x"]})"));
  EXPECT_FALSE(container->has_bin);
}

TEST(GltfContainerTest, ReadsACentreInTheBinaryPart) {
  const float center[] = {4, 5, 6};
  std::string bytes = B3dmOf(GlbOf("{}", ""), R"({"RTC_CENTER":{"byteOffset":0}})");
  const size_t table = bytes.find("glTF");
  bytes.insert(table, std::string(reinterpret_cast<const char*>(center), sizeof(center)));
  bytes = WithNumber(WithNumber(bytes, 8, static_cast<uint32_t>(bytes.size())), 16, sizeof(center));
  EXPECT_EQ(ParseGltfContainer(bytes, "a")->origin, Point3(4, 5, 6));
  EXPECT_THAT(Message(WithNumber(bytes, 16, 8)), HasSubstr("no room"));
}

TEST(GltfContainerTest, KeepsTheChunkAsAPrefix) {
  for (const size_t length : {0, 1, 4, 7}) {
    for (const bool is_b3dm : {false, true}) {
      const std::string glb = GlbOf("{}", std::string(length, 'x'));
      const std::string bytes = is_b3dm ? B3dmOf(glb, "{}", "{}") : glb;
      const absl::StatusOr<GltfContainer> before = ParseGltfContainer(bytes, "a");
      const absl::StatusOr<std::string> written = WriteGltfContainer(*before, {{"a", 1}}, "added", "a");
      ASSERT_TRUE(written.ok()) << written.status();
      const absl::StatusOr<GltfContainer> after = ParseGltfContainer(*written, "b");
      ASSERT_TRUE(after.ok()) << after.status();
      EXPECT_EQ(after->bin.substr(0, before->bin.size()), before->bin);
      EXPECT_EQ(after->bin.substr((length + 3) / 4 * 4, 5), "added");
      EXPECT_EQ(after->json.dump(), R"({"a":1})");
      EXPECT_EQ(written->size() % 8, 0u);
      // Of a b3dm: all but the magic, the version and the length.
      if (is_b3dm) {
        EXPECT_EQ(after->head.substr(12), before->head.substr(12));
      }
    }
  }
}

TEST(GltfContainerTest, KeepsOtherChunks) {
  std::string bytes = GlbOf("{}", "data");
  const std::string chunk("\4\0\0\0XYZ\0more", 12);
  bytes = WithNumber(bytes + chunk, 8, static_cast<uint32_t>(bytes.size() + chunk.size()));
  const absl::StatusOr<GltfContainer> container = ParseGltfContainer(bytes, "a");
  ASSERT_TRUE(container.ok()) << container.status();
  EXPECT_EQ(container->trailing, chunk);
  EXPECT_TRUE(WriteGltfContainer(*container, {{"a", 1}}, "", "a")->ends_with(chunk));
}

TEST(GltfContainerTest, RefusesMalformedFiles) {
  const std::string glb = GlbOf("{}", "data");
  const std::string b3dm = B3dmOf(glb, "{}");
  EXPECT_EQ(Message(""), "a.glb: byte 0: expected a glb, which begins with glTF");
  EXPECT_EQ(Message(WithNumber(glb, 4, 1)), "a.glb: byte 4: glTF 1.0 is not read; expected 2.0");
  EXPECT_THAT(Message(WithNumber(glb, 8, 1000)), HasSubstr("byte 8: the glb has 1000 bytes"));
  EXPECT_THAT(Message(WithNumber(glb, 12, 1000)), HasSubstr("byte 12: a chunk of 1000 bytes"));
  EXPECT_THAT(Message(WithNumber(glb, 16, 0)), HasSubstr("byte 16: expected the JSON chunk"));
  EXPECT_THAT(Message(WithNumber(glb, 24, 1000)), HasSubstr("byte 24: a chunk of 1000 bytes"));
  EXPECT_THAT(Message(GlbOf("[]", "")), HasSubstr("byte 20: expected a JSON object"));
  EXPECT_THAT(Message(GlbOf("{]", "")), HasSubstr("byte 21: not JSON"));
  EXPECT_THAT(Message(b3dm.substr(0, 20)), HasSubstr("byte 20: expected a header of 28 bytes"));
  EXPECT_THAT(Message(WithNumber(b3dm, 4, 2)), HasSubstr("byte 4: b3dm version 2"));
  EXPECT_THAT(Message(WithNumber(b3dm, 8, 1 << 20)), HasSubstr("byte 8: the b3dm has"));
  EXPECT_THAT(Message(WithNumber(b3dm, 20, 0xffffffff)), HasSubstr("byte 20: the table ends behind the file"));
  EXPECT_THAT(Message(B3dmOf(glb, R"({"RTC_CENTER":[1,2]})")), HasSubstr("JSON /RTC_CENTER: expected 3 numbers"));
}

}  // namespace
}  // namespace tilemend
