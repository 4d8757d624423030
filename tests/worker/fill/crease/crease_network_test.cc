#include "worker/fill/crease/crease_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "tests/worker/fill/crease/crease_loops.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {
namespace {

CreaseNetwork CreasesOf(const CellHoles& work) { return FindCreases(LoopsOf(work), Bends::kOverSeveralEdges); }

TEST(CreaseNetworkTest, CarriesARoofsEdgeThroughAHole) {
  const CreaseNetwork network = CreasesOf(WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, kNoise));
  ASSERT_EQ(network.curves.size(), 1u);
  const Point3 middle = network.curves[0].At(0.5);
  EXPECT_NEAR(middle.y(), 0, kNoise);
  EXPECT_NEAR(middle.z(), kWallHeight, kNoise);
}

TEST(CreaseNetworkTest, CarriesARoofsEdgeAndTheFootOfTheWallThroughOneHole) {
  const CreaseNetwork network = CreasesOf(WorkOfSheet(Disc(0, kWallHeight / 2, 8), FoldToBuilding, kNoise));
  ASSERT_EQ(network.curves.size(), 2u);
  std::vector<double> heights = {network.curves[0].At(0.5).z(), network.curves[1].At(0.5).z()};
  std::sort(heights.begin(), heights.end());
  EXPECT_NEAR(heights[0], 0, kNoise);
  EXPECT_NEAR(heights[1], kWallHeight, kNoise);
}

TEST(CreaseNetworkTest, JoinsCreasesOnlyAcrossIslands) {
  const auto ring = [](double u, double v) {
    const double r = std::hypot(u, v - kWallHeight);
    return r > 2.2 && r < 7;
  };
  const CreaseNetwork network = CreasesOf(WorkOfSheet(ring, FoldToBuilding, kNoise));
  ASSERT_EQ(network.ends.size(), 4u);
  ASSERT_EQ(network.curves.size(), 2u);
  for (const CreaseCurve& c : network.curves) {
    EXPECT_NE(network.ends[c.from].loop, network.ends[c.to].loop);
    EXPECT_LT((c.finish - c.start).norm(), 7);
  }
}

TEST(CreaseNetworkTest, MeetsInTheCornerOfABox) {
  const CreaseNetwork network = CreasesOf(WorkOfBoxCorner(6, kNoise));
  ASSERT_EQ(network.corners.size(), 1u);
  EXPECT_NEAR(network.corners[0].position.norm(), 0, 3 * kNoise);
  EXPECT_EQ(network.curves.size(), 3u);
}

// Four creases and the planes between them meet in one point, where two corners would have no way between them.
TEST(CreaseNetworkTest, MeetsInTheTipOfAPyramid) {
  for (const double noise : {0.0, kNoise}) {
    const auto pyramid = [](const Point3& p) {
      return Point3(p.x(), p.y(), -1.2 * std::max(std::abs(p.x()), std::abs(p.y() - 5)));
    };
    const CreaseNetwork network = CreasesOf(WorkOfSheet(Disc(0, 5, 6), pyramid, noise));
    ASSERT_EQ(network.corners.size(), 1u);
    EXPECT_LT((network.corners[0].position - Point3(0, 5, 0)).norm(), 1e-9 + 3 * noise);
    EXPECT_EQ(network.corners[0].curves.size(), 4u);
    EXPECT_EQ(network.curves.size(), 4u);
  }
}

// The rim crosses the roof's edge three times at the one side, and touches it from below in the middle.
TEST(CreaseNetworkTest, FollowsARimThatWeavesAboutTheCrease) {
  const auto hole = [](double u, double v) {
    const bool bite = u > 4 && u < 6 && v > kWallHeight - 2, tooth = u < -5 && v > kWallHeight && v < kWallHeight + 2;
    const bool peninsula = std::abs(u) < 1 && v < kWallHeight;
    return std::hypot(u, v - kWallHeight) < 7 && !(bite && v < kWallHeight) && !tooth && !peninsula;
  };
  const CellHoles work = WorkOfSheet(hole, FoldToBuilding, kNoise);
  const std::vector<RimLoop> loops = LoopsOf(work);
  const CreaseNetwork network = FindCreases(loops, Bends::kOverSeveralEdges);
  ASSERT_FALSE(network.curves.empty());
  double length = 0;
  for (const CreaseCurve& c : network.curves) {
    for (const double t : {0.0, 0.5, 1.0}) {
      EXPECT_NEAR(c.At(t).y(), 0, 2 * kNoise);
      EXPECT_NEAR(c.At(t).z(), kWallHeight, 2 * kNoise);
    }
    length += (c.finish - c.start).norm();
    for (const Point3& p : loops[0].positions) {  // no curve runs over a vertex of the rim
      const double t = (p - c.start).dot(c.finish - c.start) / (c.finish - c.start).squaredNorm();
      if (t > 0.01 && t < 0.99) {
        EXPECT_GT((p - c.At(t)).norm(), 0.2) << p.transpose();
      }
    }
  }
  EXPECT_LT(length, 12) << "the crease inside the hole alone";
}

// A round tower with a flat roof: the crease between them is a circle.
TEST(CreaseNetworkTest, FollowsACurvedCrease) {
  const double radius = 15;
  const auto tower = [&](const Point3& p) {
    const double angle = p.x() / radius, r = radius - 0.7 * std::max(0.0, p.y());
    return Point3(r * std::sin(angle), radius - r * std::cos(angle), std::min(0.0, p.y()));
  };
  const std::vector<RimLoop> rim = LoopsOf(WorkOfSheet(Disc(0, 0, 6), tower, 0));
  ASSERT_EQ(rim.size(), 1u);
  const CreaseNetwork network = FindCreases(rim, Bends::kOverSeveralEdges);
  ASSERT_EQ(network.curves.size(), 1u);
  for (const double t : {0.25, 0.5, 0.75}) {
    const Point3 p = network.curves[0].At(t);
    EXPECT_NEAR(std::hypot(p.x(), p.y() - radius), radius, 0.05);
    EXPECT_NEAR(p.z(), 0, 0.05);
  }
}

// Photogrammetry of vegetation: neighbouring triangles stand at any angle to each other.
TEST(CreaseNetworkTest, CarriesNothingThroughRoughGround) {
  const auto same = [](const Point3& p) { return p; };
  for (const double noise : {0.1, 0.2, 0.35}) {
    for (const double u : {-6.0, 0.0, 5.0}) {
      const CreaseNetwork network = CreasesOf(WorkOfSheet(Disc(u, 5, 6), same, noise));
      EXPECT_TRUE(network.curves.empty()) << noise << " " << u;
    }
  }
}

// A crease that fades out inside the hole leads nowhere.
TEST(CreaseNetworkTest, LeavesASingleEndAlone) {
  const auto half = [](const Point3& p) {
    const double fold = std::clamp(0.5 - p.x() / 20, 0.0, 1.0);
    return Point3(p.x(), p.y(), -fold * std::max(0.0, p.y() - 5));
  };
  const CreaseNetwork network = CreasesOf(WorkOfSheet(Disc(0, 5, 7), half, kNoise));
  EXPECT_EQ(network.ends.size(), 1u);
  EXPECT_TRUE(network.curves.empty());
}

}  // namespace
}  // namespace tilemend
