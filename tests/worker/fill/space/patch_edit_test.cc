#include "worker/fill/space/patch_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

// A hole in flat ground, closed by a fan about one point.
class PatchEditTest : public testing::Test {
 protected:
  PatchEditTest() {
    patch_.new_points = {{0, -5, 0}};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, hole_.size()});
    count_ = static_cast<int32_t>(patch_.triangles.size());
  }

  const CellHoles work_ = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
  int32_t count_ = 0;
};

TEST_F(PatchEditTest, WhatIsPutBackIsAsItWas) {
  const std::vector<Triangle> before = patch_.triangles;
  PatchEdit edit(hole_, patch_);
  edit.TakeOut(1);
  edit.PutIn({before[1][0], before[1][1], edit.AddPoint({0, -5, 1})});
  edit.TakeOutFrom(count_);
  edit.PutBack(1);
  edit.Finish();
  EXPECT_EQ(patch_.triangles, before);
}

TEST_F(PatchEditTest, EdgesMayBeMadeAnewWhereTrianglesAreTakenOut) {
  PatchEdit edit(hole_, patch_);
  const int32_t rim = edit.Corners(0)[1];
  EXPECT_FALSE(edit.MayJoin(rim, hole_.size()));
  for (int32_t t = 0; t < count_; ++t) edit.TakeOut(t);
  EXPECT_TRUE(edit.MayJoin(rim, hole_.size()));
}

TEST_F(PatchEditTest, ATriangleTwiceHasOverfullEdges) {
  PatchEdit edit(hole_, patch_);
  EXPECT_FALSE(edit.HasOverfullEdge(0));
  const Triangle again = edit.Corners(0);
  edit.PutIn(again);
  EXPECT_TRUE(edit.HasOverfullEdge(count_));
}

TEST_F(PatchEditTest, PiecesHangTogetherAtEdges) {
  std::vector<bool> taken(patch_.triangles.size(), false);
  taken[0] = taken[1] = taken[3] = true;
  EXPECT_THAT(PatchEdit(hole_, patch_).PiecesOf(taken), ElementsAre(ElementsAre(0, 1), ElementsAre(3)));
}

}  // namespace
}  // namespace tilemend
