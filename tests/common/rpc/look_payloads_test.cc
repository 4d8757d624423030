#include "common/rpc/look_payloads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using testing::ElementsAre;

TEST(LookPayloadsTest, ColoursComeBack) {
  for (const std::optional<Rgb>& colour : {std::optional<Rgb>(), std::optional(Rgb{0, 0, 0}),
                                           std::optional(Rgb{255, 255, 255}), std::optional(Rgb{1, 20, 200})}) {
    EXPECT_EQ(ColourFromProto(ColourToProto(colour)), colour);
  }
}

TEST(LookPayloadsTest, FilesComeBack) {
  const TileFiles files{{"a/b.mtl"}, {"a/\xff.jpg", "c.png"}, {"gone"}};
  const auto back = FromProto(ToProto(files));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->libraries, files.libraries);
  EXPECT_EQ(back->images, files.images);
  EXPECT_EQ(back->warnings, files.warnings);
}

TEST(LookPayloadsTest, PathsOutOfTheSceneAreRefused) {
  for (const std::string& path : {std::string("/etc/passwd"), std::string("../a"), std::string("a/../../b"),
                                  std::string(), std::string("a\0b", 3)}) {
    v1::TileFiles proto;
    proto.add_images(path);
    EXPECT_EQ(FromProto(proto).status().code(), absl::StatusCode::kInvalidArgument) << path;
  }
}

TEST(LookPayloadsTest, NamesThatTheOutputNeedsItselfAreRefused) {
  for (const char* path : {"Data/T/T.obj", "./report.json", ".tilemend-results"}) {
    v1::TileFiles proto;
    proto.add_libraries(path);
    EXPECT_EQ(FromProto(proto).status().code(), absl::StatusCode::kInvalidArgument) << path;
  }
}

TEST(LookPayloadsTest, ColoursOfHolesComeBackOnceEach) {
  v1::AssembleInput input;
  SetColours({{{3, {1, {10, 20, 30}, true}}, {7, {7, {1, 2, 3}, false}}}, true}, input);
  auto back = ColoursOf(input);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_TRUE(back->on_vertices);
  ASSERT_EQ(back->of_holes.size(), 2U);
  EXPECT_EQ(back->of_holes.at(3).group, 1);
  EXPECT_EQ(back->of_holes.at(3).colour, (Rgb{10, 20, 30}));
  EXPECT_TRUE(back->of_holes.at(3).known);
  EXPECT_FALSE(back->of_holes.at(7).known);
  *input.add_colours() = input.colours(0);
  EXPECT_FALSE(ColoursOf(input).ok());
}

}  // namespace
}  // namespace tilemend
