#include "worker/service/tile_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/rpc/clear_payloads.h"
#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr char kTriangles[] = "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 5 0 1\nv 6 0 1\nv 5 1 1\nf 1 2 3\nf 4 5 6\n";

class TileReadingTest : public testing::Test {
 protected:
  TileReadingTest() {
    folder_.Write("a.obj", kTriangles);
    tile_.set_root(folder_.path());
    tile_.set_path("a.obj");
    tile_.set_digest(FileDigest(kTriangles));
  }

  TemporaryFolder folder_;
  v1::TileRef tile_;
};

TEST_F(TileReadingTest, ReadsATileThatIsAsItWasSurveyed) {
  EXPECT_EQ(PathOf(tile_), folder_ / "a.obj");
  EXPECT_EQ(ReadTile(tile_).value_or(""), kTriangles);
  EXPECT_EQ(ReadSurveyed(tile_).value_or(""), kTriangles);
}

TEST_F(TileReadingTest, RefusesATileThatHasChanged) {
  folder_.Write("a.obj", "v 0 0 1\n");
  EXPECT_THAT(std::string(ReadSurveyed(tile_).status().message()), HasSubstr("a.obj"));
}

TEST_F(TileReadingTest, TheMeshIsWithoutWhatIsTakenOut) {
  EXPECT_THAT(MeshOf(tile_, kTriangles)->mesh.triangles, SizeIs(2));
  *tile_.add_clear() = ToProto(ClearArea{{{{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}}}, 2});
  const auto cleared = MeshOf(tile_, kTriangles);
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  EXPECT_THAT(cleared->mesh.triangles, SizeIs(1));
  EXPECT_THAT(cleared->mesh.points, SizeIs(6));
}

}  // namespace
}  // namespace tilemend
