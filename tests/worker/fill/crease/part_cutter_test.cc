#include "worker/fill/crease/part_cutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

struct Cut {
  std::vector<PartBoundary> parts;
  double area = 0;  // of all parts, as the sum of their vector areas' lengths
};

// Cuts with one point in the middle of each curve.
Cut CutHole(const CellHoles& work) {
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const CreaseNetwork network = FindCreases(hole.loops, Bends::kOverSeveralEdges);
  std::vector<Point3> new_points;
  std::vector<std::vector<int32_t>> curve_points;
  for (const CreaseCorner& corner : network.corners) new_points.push_back(corner.position);
  for (const CreaseCurve& curve : network.curves) {
    curve_points.push_back({static_cast<int32_t>(new_points.size())});
    new_points.push_back(curve.At(0.5));
  }
  Cut cut{CutAlong(network, hole, new_points, curve_points)};
  std::set<std::pair<int32_t, int32_t>> edges;
  for (const PartBoundary& boundary : cut.parts) {
    const HolePart part = MakePart(hole, new_points, boundary);
    cut.area += part.hole.VectorArea().norm();
    for (const RegionSegment& s : part.hole.segments) {
      EXPECT_TRUE(edges.insert({part.vertices[s.from], part.vertices[s.to]}).second) << "an edge of two parts";
    }
  }
  for (const RegionSegment& s : hole.segments) EXPECT_TRUE(edges.contains({s.from, s.to}));
  for (const auto& [a, b] : edges) {
    if (a >= hole.size() || b >= hole.size()) {
      EXPECT_TRUE(edges.contains({b, a})) << "a crease has a part on either side";
    }
  }
  return cut;
}

TEST(PartCutterTest, PartsARoofFromItsWall) {
  const Cut cut = CutHole(WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, 0));
  EXPECT_EQ(cut.parts.size(), 2u);
  EXPECT_NEAR(cut.area, 112, 0.1) << "the squares of the hole";
}

TEST(PartCutterTest, PartsTheThreeSidesAtACorner) { EXPECT_EQ(CutHole(WorkOfBoxCorner(6, 0)).parts.size(), 3u); }

TEST(PartCutterTest, PutsAnIslandIntoThePartThatItLiesIn) {
  const auto hole = [](double u, double v) {
    return std::hypot(u, v - kWallHeight) < 7 && std::hypot(u - 1, v - kWallHeight - 3) > 1.5;
  };
  const Cut cut = CutHole(WorkOfSheet(hole, FoldToBuilding, 0));
  ASSERT_EQ(cut.parts.size(), 2u);
  EXPECT_EQ(cut.parts[0].size() + cut.parts[1].size(), 3u);
}

TEST(PartCutterTest, GoesRoundAnIslandThatACreaseEndsAt) {
  const auto ring = [](double u, double v) {
    const double r = std::hypot(u, v - kWallHeight);
    return r > 2.2 && r < 7;
  };
  const Cut cut = CutHole(WorkOfSheet(ring, FoldToBuilding, 0));
  ASSERT_EQ(cut.parts.size(), 2u);
  for (const PartBoundary& part : cut.parts) EXPECT_EQ(part.size(), 1u);
}

}  // namespace
}  // namespace tilemend
