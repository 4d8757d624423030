#include "common/codec/draco_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace tilemend {
namespace {

using ::testing::HasSubstr;

LatticeMesh Mesh(int32_t points, int32_t triangles) {
  LatticeMesh mesh;
  for (int64_t i = 0; i < points; ++i) {
    mesh.points.push_back(
        {static_cast<int32_t>(i * 7919 % 1000), static_cast<int32_t>(i * 104729 % 1000), static_cast<int32_t>(i % 17)});
  }
  for (int32_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({i % points, (i * 31 + 1) % points, (i * 17 + 2) % points});
  }
  return mesh;
}

// The Draco stream of a mesh: its frame's payload behind the least corner.
std::string StreamOf(const LatticeMesh& mesh) {
  return std::string(UnwrapFrame(EncodeDraco(mesh))->payload.substr(12));
}

TEST(FrameTest, GivesBackWhatItHolds) {
  for (const std::string& payload : {std::string(), std::string("a\0b", 3), std::string(100'000, 'x')}) {
    for (const FrameContent content : {FrameContent::kPlain, FrameContent::kDraco}) {
      const std::string bytes = WrapFrame(content, payload);
      const auto frame = UnwrapFrame(bytes);
      ASSERT_TRUE(frame.ok()) << frame.status();
      EXPECT_EQ(frame->content, content);
      EXPECT_EQ(frame->payload, payload);
    }
  }
}

// The check values of RFC 3720, B.4, and the usual one of "123456789", whose length is no multiple of eight.
TEST(FrameTest, ChecksumIsCrc32c) {
  std::string rising(32, '\0');
  for (size_t i = 0; i < rising.size(); ++i) rising[i] = static_cast<char>(i);
  for (const auto& [payload, checksum] : {std::pair(std::string(32, '\0'), 0x8a9136aau),
                                          {std::string(32, '\xff'), 0x62a8ab43u},
                                          {rising, 0x46dd794eu},
                                          {std::string("123456789"), 0xe3069283u}}) {
    EXPECT_EQ(LoadUint32(WrapFrame(FrameContent::kPlain, payload).data() + 13), checksum);
  }
}

TEST(FrameTest, SaysWhatIsWrong) {
  const std::string good = WrapFrame(FrameContent::kPlain, "payload");
  const auto message = [](const std::string& bytes) { return std::string(UnwrapFrame(bytes).status().message()); };
  const auto with = [&good](size_t at, char c) {
    std::string bad = good;
    bad[at] = c;
    return bad;
  };
  EXPECT_THAT(message("TML"), HasSubstr("begins with TMLM"));
  EXPECT_THAT(message(with(0, 'x')), HasSubstr("begins with TMLM"));
  EXPECT_THAT(message(with(4, 7)), HasSubstr("unknown content 7"));
  EXPECT_THAT(message(good + "x"), HasSubstr("expected 7 bytes after the header, found 8"));
  EXPECT_THAT(message(good.substr(0, 20)), HasSubstr("expected 7 bytes after the header, found 3"));
  EXPECT_THAT(message(with(good.size() - 1, 'x')), HasSubstr("the checksum does not match"));
}

TEST(NumbersTest, AreLittleEndian) {
  std::string bytes;
  AppendUint32(0x01020384, bytes);
  EXPECT_EQ(bytes, "\x84\3\2\1");
  EXPECT_EQ(LoadUint32(bytes.data()), 0x01020384u);
}

TEST(CheckCountsTest, HoldsBothCountsAgainstTheLimits) {
  const DracoLimits limits{.max_points = 10, .max_triangles = 20};
  EXPECT_TRUE(CheckCounts(10, 20, limits).ok());
  EXPECT_EQ(CheckCounts(11, 20, limits).code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(CheckCounts(10, 21, limits).code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(CheckCounts(UINT64_MAX, 0, limits).code(), absl::StatusCode::kResourceExhausted);
}

// Indices are stored in another way from 256 and from 2^16 points.
TEST(CheckDracoStreamTest, GivesTheCountsOfWhatDracoWrites) {
  for (const int32_t points : {3, 255, 256, 65535, 65536, 70'000}) {
    const auto counts = CheckDracoStream(StreamOf(Mesh(points, points / 2 + 1)), {});
    ASSERT_TRUE(counts.ok()) << points << ": " << counts.status();
    EXPECT_EQ(counts->points, static_cast<uint32_t>(points));
    EXPECT_EQ(counts->triangles, static_cast<uint32_t>(points / 2 + 1));
  }
}

TEST(CheckDracoStreamTest, RefusesEveryStreamThatEndsInItsHeaders) {
  for (const int32_t points : {30, 300, 66'000}) {
    const std::string stream = StreamOf(Mesh(points, 40));
    const size_t index_bytes = points < 256 ? 1 : points < 65536 ? 2 : 3;
    const size_t headers = 11 + 1 + (points < 128 ? 1 : points < 16384 ? 2 : 3) + 1 + 8 + 3 + 1;
    for (size_t size = 0; size < headers; ++size) {
      EXPECT_FALSE(CheckDracoStream(stream.substr(0, size), {}).ok()) << size;
    }
    EXPECT_FALSE(CheckDracoStream(stream.substr(0, headers + 40 * index_bytes), {}).ok()) << points;
  }
}

TEST(CheckDracoStreamTest, RefusesNoPoints) {
  std::string stream = StreamOf(Mesh(30, 40));
  stream[12] = '\0';
  EXPECT_THAT(std::string(CheckDracoStream(stream, {}).status().message()), HasSubstr("at least one point"));
}

std::string MessageOf(const std::string& stream) {
  const auto mesh = DecodeDraco(WrapFrame(FrameContent::kDraco, std::string(12, '\0') + stream), {});
  EXPECT_FALSE(mesh.ok());
  return std::string(mesh.status().message());
}

// A peer that computes the checksum right still does not get past the guard.
TEST(CheckDracoStreamTest, GuardsDracoFromForgedStreams) {
  const std::string bytes = EncodeDraco(Mesh(30, 40));
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
