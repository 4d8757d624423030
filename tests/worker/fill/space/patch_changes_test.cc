#include "worker/fill/space/patch_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/outline_hole.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// A fan about point 5; its triangle k begins at vertex k of the hole, and 0 and 1 end at the outline.
class PatchChangesTest : public testing::Test {
 protected:
  explicit PatchChangesTest(const Point3& tip = {2, 2, 5}) {
    patch_.new_points = {tip};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, 5});
  }

  std::vector<ChangeNear> ChangesAt(int32_t t) {
    const PatchEdit edit(hole_, patch_);
    return tilemend::ChangesAt(t, {2, 1, 5}, 6, hole_, edit, FreeOutline(hole_));
  }
  // Of those, the ones without vertex v.
  std::vector<ChangeNear> ChangesWithout(int32_t t, int32_t v) {
    std::vector<ChangeNear> changes = ChangesAt(t);
    std::erase_if(changes, [&](const ChangeNear& c) { return c.change.gone != v; });
    return changes;
  }

  const CellHoles work_ = HoleAtOutline();
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
};

TEST_F(PatchChangesTest, PointsInsideMoveAndMerge) {
  const std::vector<ChangeNear> changes = ChangesWithout(2, 5);
  ASSERT_EQ(changes.size(), 1 + 5u) << "moved, or merged with one of the rim";
  EXPECT_EQ(changes[0].change.in.size(), 5u);
  EXPECT_THAT(changes[0].places, Not(IsEmpty()));
  EXPECT_EQ(changes[1].change.in.size(), 3u);
}

TEST_F(PatchChangesTest, TheRimStays) {
  for (const int32_t v : {2, 3}) EXPECT_THAT(ChangesWithout(2, v), IsEmpty());
  const auto divides_rim = [](const ChangeNear& c) { return c.change.out.size() == 1 && c.change.in.size() == 2; };
  EXPECT_TRUE(std::ranges::none_of(ChangesAt(2), divides_rim));
}

TEST_F(PatchChangesTest, PointsOfTheOutlineMoveNearWhereTheyArePlanned) {
  const std::vector<ChangeNear> changes = ChangesWithout(0, 1);
  ASSERT_EQ(changes.size(), 1 + 2u) << "moved, or merged with its neighbours on the outline";
  EXPECT_EQ(changes[0].change.planned, Point3(2, 0, 5));
  EXPECT_THAT(changes[0].change.in, ElementsAre(Triangle{0, 6, 5}, Triangle{6, 2, 5}));
  EXPECT_THAT(changes[1].change.in, ElementsAre(Triangle{0, 2, 5}));
}

TEST_F(PatchChangesTest, EdgesOfTheOutlineAreDividedWhereTheyArePlanned) {
  const std::vector<ChangeNear> changes = ChangesAt(0);
  const auto divided = std::ranges::find_if(
      changes, [](const ChangeNear& c) { return c.change.out.size() == 1 && c.change.in.size() == 2; });
  ASSERT_NE(divided, changes.end());
  EXPECT_EQ(divided->change.planned, Point3(1.8, 0, 5)) << "not too near to its end";
}

// A fan about a point beside the outline.
class PatchChangesAtOutlineTest : public PatchChangesTest {
 protected:
  PatchChangesAtOutlineTest() : PatchChangesTest({1, 0.05, 5}) {}
};

TEST_F(PatchChangesAtOutlineTest, ATriangleBesideTheOutlineMayGo) {
  const auto is_removal = [](const ChangeNear& c) { return c.change.in.empty(); };
  std::vector<ChangeNear> removals = ChangesAt(0);
  std::erase_if(removals, [&](const ChangeNear& c) { return !is_removal(c); });
  ASSERT_EQ(removals.size(), 1u);
  EXPECT_THAT(removals[0].change.out, ElementsAre(0));
  EXPECT_EQ(removals[0].change.freed, 5) << "the point comes to the boundary";
  EXPECT_TRUE(std::ranges::none_of(ChangesAt(2), is_removal)) << "at the rim";
}

}  // namespace
}  // namespace tilemend
