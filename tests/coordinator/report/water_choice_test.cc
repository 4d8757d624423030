#include "coordinator/report/water_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(WaterChoiceTest, FindsWaterOrDoesNot) {
  const auto find = ReadWaterChoice(kFindWater, {}), off = ReadWaterChoice(kNoWater, {});
  ASSERT_TRUE(find.ok() && off.ok());
  EXPECT_TRUE(find->options.find);
  EXPECT_FALSE(off->options.find);
  EXPECT_EQ(find->digest, "");
}

TEST(WaterChoiceTest, AFileGivesExceptionsAndCountsByItsContent) {
  const TemporaryFolder folder;
  const std::string text = R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]})";
  const auto choice = ReadWaterChoice(folder.Write("areas.geojson", text), {});
  ASSERT_TRUE(choice.ok()) << choice.status();
  EXPECT_TRUE(choice->options.find);
  EXPECT_EQ(choice->options.areas.size(), 1U);
  EXPECT_EQ(choice->digest, Sha256Hex(text));
}

TEST(WaterChoiceTest, AllOfASecondFileIsCleared) {
  const TemporaryFolder folder;
  const std::string ring = R"("geometry": {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}})";
  const std::string plain = R"({"type": "Feature", "properties": {}, )" + ring;
  WaterChoice choice = *ReadWaterChoice(folder.Write("a.geojson", plain), {});
  ASSERT_TRUE(AddClearFile("", {}, choice).ok());
  EXPECT_EQ(choice.options.areas.size(), 1U);
  ASSERT_TRUE(AddClearFile(folder.Write("b.geojson", plain), {}, choice).ok());
  ASSERT_EQ(choice.options.areas.size(), 2U);
  EXPECT_FALSE(choice.options.areas[0].clear);
  EXPECT_TRUE(choice.options.areas[1].clear);
  EXPECT_EQ(choice.clear_digest, Sha256Hex(plain));
  const std::string river = R"({"type": "Feature", "properties": {"kind": "river"}, )" + ring;
  const absl::Status refused = AddClearFile(folder.Write("c.geojson", river), {}, choice);
  EXPECT_TRUE(absl::IsInvalidArgument(refused)) << refused;
  EXPECT_THAT(std::string(refused.message()), HasSubstr("kind is river, but clear"));
}

TEST(WaterChoiceTest, NamesAFileThatCannotBeUsed) {
  const TemporaryFolder folder;
  const absl::Status missing = ReadWaterChoice(folder / "none.geojson", {}).status();
  EXPECT_TRUE(absl::IsNotFound(missing)) << missing;
  EXPECT_THAT(std::string(missing.message()), HasSubstr("none.geojson"));
  const absl::Status broken = ReadWaterChoice(folder.Write("broken.geojson", "{"), {}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(broken)) << broken;
  EXPECT_THAT(std::string(broken.message()), HasSubstr("broken.geojson"));
}

}  // namespace
}  // namespace tilemend
