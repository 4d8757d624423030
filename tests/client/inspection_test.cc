#include "client/inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/report/tile_checks.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(InspectSceneTest, WarnsOfFilesThatTilesNameAndThatAreMissing) {
  const TemporaryFolder folder;
  for (const auto& [path, bytes] : OsgbScene().Files()) {
    if (!path.ends_with("Tile_+001_+000_L2_3.osgb")) folder.Write(path, bytes);
  }
  auto scene = LoadScene(folder.path(), ReadTileBounds);
  ASSERT_TRUE(scene.ok()) << scene.status();
  const Inspection inspection = InspectScene(*std::move(scene), {});
  EXPECT_TRUE(inspection.errors.empty());
  EXPECT_THAT(inspection.warnings, ElementsAre(HasSubstr("L2_3.osgb")));
}

}  // namespace
}  // namespace tilemend
