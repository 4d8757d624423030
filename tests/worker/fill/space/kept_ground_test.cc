#include "worker/fill/space/kept_ground.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {
namespace {

// A hole in flat ground, closed by a hill that is made anew as flat ground.
class KeptGroundTest : public testing::Test {
 protected:
  void MakeHill(const Point3& top) {
    patch_.new_points = {top};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, hole_.size()});
  }

  // Numbers the flat triangles from this on.
  int32_t MakeFlat(PatchEdit& edit) {
    for (const int32_t t : Hill()) edit.TakeOut(t);
    const std::vector<int32_t> loop = LoopsOf(hole_.segments)[0];
    const int32_t first = edit.count();
    for (size_t i = 1; i + 1 < loop.size(); ++i) edit.PutIn({loop[0], loop[i], loop[i + 1]});
    return first;
  }

  Piece Hill() const {
    Piece hill;
    for (int32_t t = 0; t < std::ssize(hole_.segments); ++t) hill.push_back(t);
    return hill;
  }

  std::set<int32_t> Rim() const {
    std::set<int32_t> rim;
    for (const RegionSegment& s : hole_.segments) rim.insert(s.from);
    return rim;
  }

  static int64_t Left(int32_t first, const PatchEdit& edit) {
    int64_t left = 0;
    for (int32_t t = first; t < edit.count(); ++t) left += edit.IsGone(t) ? 0 : 1;
    return left;
  }

  const CellHoles work_ = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
};

TEST_F(KeptGroundTest, ALowHillMayGo) {
  MakeHill({0.1, -5.2, 0.1});
  PatchEdit edit(hole_, patch_);
  const KeptGround ground(Hill(), Rim(), edit);
  EXPECT_TRUE(ground.IsKept(MakeFlat(edit), edit));
}

TEST_F(KeptGroundTest, PutsTheTopBack) {
  MakeHill({0.1, -5.2, 0.8});
  PatchEdit edit(hole_, patch_);
  const KeptGround ground(Hill(), Rim(), edit);
  const int32_t first = MakeFlat(edit);
  const int64_t flat = Left(first, edit);
  EXPECT_FALSE(ground.IsKept(first, edit));
  ground.PutBack(
      first, [] { return CrossingIndex({}); }, edit);
  EXPECT_TRUE(ground.IsKept(first, edit));
  EXPECT_EQ(Left(first, edit), flat + 2);
  for (int32_t t = first; t < edit.count(); ++t) EXPECT_FALSE(edit.HasOverfullEdge(t));
}

TEST_F(KeptGroundTest, LeavesOutWhatWouldCross) {
  MakeHill({0.1, -5.2, 0.8});
  PatchEdit edit(hole_, patch_);
  const KeptGround ground(Hill(), Rim(), edit);
  const int32_t first = MakeFlat(edit), count = edit.count();
  const std::vector<SpaceTriangle> roof = {{Point3(-9, -9, 0.5), Point3(9, -9, 0.5), Point3(0, 9, 0.5)}};
  ground.PutBack(
      first, [&] { return CrossingIndex(roof); }, edit);
  EXPECT_FALSE(ground.IsKept(first, edit));
  EXPECT_EQ(edit.count(), count);
  EXPECT_EQ(Left(first, edit), count - first) << "as they were";
}

// Only what faces up on all sides is ground.
TEST_F(KeptGroundTest, ASpireIsNoGround) {
  MakeHill({0.1, -5.2, 30});
  PatchEdit edit(hole_, patch_);
  const KeptGround ground(Hill(), Rim(), edit);
  EXPECT_TRUE(ground.IsKept(MakeFlat(edit), edit));
}

}  // namespace
}  // namespace tilemend
