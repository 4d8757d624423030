#include "worker/fill/hole/rim_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Loop = std::vector<int32_t>;

TEST(LoopsOfTest, LinksSegmentsInAnyOrder) {
  const std::vector<RegionSegment> segments = {{4, 2}, {7, 4}, {2, 9}, {9, 7}};
  EXPECT_THAT(LoopsOf(segments), ElementsAre(Loop{4, 2, 9, 7}));
}

TEST(LoopsOfTest, FindsEveryLoop) {
  const std::vector<RegionSegment> segments = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
  EXPECT_THAT(LoopsOf(segments), ElementsAre(Loop{0, 1, 2}, Loop{3, 4, 5}));
}

TEST(LoopsOfTest, GoesOnWithTheNextSegmentWhereLoopsTouch) {
  const std::vector<RegionSegment> one = {{0, 1}, {1, 2}, {2, 3}, {3, 1}, {1, 4}, {4, 0}};
  EXPECT_THAT(LoopsOf(one), ElementsAre(Loop{0, 1, 2, 3, 1, 4}));
}

TEST(LoopsOfTest, HasNoneForAnOpenChain) {
  const std::vector<RegionSegment> segments = {{0, 1}, {1, 2}, {2, 3}};
  EXPECT_THAT(LoopsOf(segments), IsEmpty());
}

RimLoop LoopWith(std::vector<Eigen::Vector3d> outside) {
  RimLoop loop;
  for (size_t i = 0; i < outside.size(); ++i) {
    loop.vertices.push_back(static_cast<int32_t>(i));
    loop.positions.emplace_back(static_cast<double>(i), 0, 0);
  }
  loop.outside = std::move(outside);
  return loop;
}

TEST(EvenNormalsTest, OutvotesASingleNormal) {
  std::vector<Eigen::Vector3d> outside(20, Eigen::Vector3d::UnitZ());
  outside[7] = Eigen::Vector3d::UnitX();
  for (const Eigen::Vector3d& n : EvenNormals(LoopWith(outside))) EXPECT_EQ(n, Eigen::Vector3d::UnitZ());
}

TEST(EvenNormalsTest, KeepsEachSideOfACrease) {
  std::vector<Eigen::Vector3d> outside(40, Eigen::Vector3d::UnitZ());
  std::fill(outside.begin() + 20, outside.end(), Eigen::Vector3d::UnitX());
  const std::vector<Eigen::Vector3d> even = EvenNormals(LoopWith(outside));
  EXPECT_EQ(even[10], Eigen::Vector3d::UnitZ());
  EXPECT_EQ(even[30], Eigen::Vector3d::UnitX());
}

TEST(EvenNormalsTest, TurnsWithTheLoop) {
  std::vector<Eigen::Vector3d> outside;
  for (int i = 0; i < 24; ++i) outside.push_back(Eigen::Vector3d(std::sin(i), 0.3 * i, 5).normalized());
  const std::vector<Eigen::Vector3d> even = EvenNormals(LoopWith(outside));
  std::rotate(outside.begin(), outside.begin() + 5, outside.end());
  const std::vector<Eigen::Vector3d> turned = EvenNormals(LoopWith(outside));
  for (size_t i = 0; i < even.size(); ++i) EXPECT_EQ(turned[i], even[(i + 5) % even.size()]);
}

TEST(EvenNormalsTest, IsZeroWhereNothingIsKnown) {
  for (const Eigen::Vector3d& n : EvenNormals(LoopWith(std::vector<Eigen::Vector3d>(9, Eigen::Vector3d::Zero())))) {
    EXPECT_TRUE(n.isZero());
  }
}

}  // namespace
}  // namespace tilemend
