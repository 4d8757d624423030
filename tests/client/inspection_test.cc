#include "client/inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/str_cat.h"
#include "coordinator/report/tile_checks.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(InspectSceneTest, TellsHowFarItIsAndWhichFilesAreMissing) {
  const TemporaryFolder folder;
  for (const auto& [path, bytes] : OsgbScene().Files()) {
    if (!path.ends_with("Tile_+001_+000_L2_3.osgb")) folder.Write(path, bytes);
  }
  auto scene = LoadScene(folder.path(), ReadTileHull);
  ASSERT_TRUE(scene.ok()) << scene.status();
  std::vector<std::string> told;
  const Inspection inspection =
      InspectScene(*std::move(scene), {}, [&](std::string_view step, size_t done, size_t all, std::string_view unit) {
        told.push_back(absl::StrCat(std::string(step), " ", done, "/", all, " ", std::string(unit)));
      });
  EXPECT_TRUE(inspection.errors.empty());
  EXPECT_EQ(told.front(), "look at the tiles 0/2 tile");
  EXPECT_EQ(told.back(), "tell ground from objects 2/2 tile");
  EXPECT_THAT(inspection.warnings, ElementsAre(HasSubstr("L2_3.osgb")));
}

}  // namespace
}  // namespace tilemend
