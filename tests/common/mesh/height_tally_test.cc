#include "common/mesh/height_tally.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tilemend {
namespace {

const PlanePolygon kSquare{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}};

// Two triangles of 0.5 m2 for each of `heights`, in a row of squares from x = 0.
TriMesh Steps(const std::vector<double>& heights) {
  TriMesh mesh;
  for (size_t k = 0; k < heights.size(); ++k) {
    const auto first = static_cast<int32_t>(mesh.points.size());
    const double x = static_cast<double>(k), z = heights[k];
    for (const Point2& p : {Point2(x, 0), Point2(x + 1, 0), Point2(x + 1, 1), Point2(x, 1)}) {
      mesh.points.emplace_back(p.x(), p.y(), z);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

TEST(HeightTallyTest, CountsAreaInsideByHeight) {
  const HeightTally tally = TallyHeights(Steps({1.0004, 2, 0.9996}), kSquare);
  EXPECT_EQ(tally.area_of_bin, (std::map<int32_t, int64_t>{{1024, 2000000}, {2048, 1000000}}));
}

TEST(HeightTallyTest, LeavesOutWhatLiesOutsideOrStandsUpright) {
  TriMesh mesh = Steps({1});
  mesh.points.insert(mesh.points.end(), {{20, 0, 1}, {21, 0, 1}, {20, 1, 1}, {2, 2, 0}, {3, 2, 0}, {3, 2, 5}});
  mesh.triangles.insert(mesh.triangles.end(), {{4, 5, 6}, {7, 8, 9}});
  EXPECT_EQ(TallyHeights(mesh, kSquare).area_of_bin, (std::map<int32_t, int64_t>{{1024, 1000000}}));
}

TEST(HeightTallyTest, HeightsBelowZeroHaveBinsOfTheirOwn) {
  EXPECT_EQ(TallyHeights(Steps({-0.001}), kSquare).area_of_bin.begin()->first, -1);
}

TEST(HeightTallyTest, HeightsThatNoSurfaceHasAreInTheLastBin) {
  EXPECT_EQ(HeightBinOf(1e9), std::numeric_limits<int32_t>::max());
  EXPECT_EQ(HeightBinOf(-1e9), -std::numeric_limits<int32_t>::max());
}

TEST(HeightTallyTest, SumsDoNotDependOnTheirOrder) {
  const HeightTally a = TallyHeights(Steps({1.3, 2.1}), kSquare), b = TallyHeights(Steps({2.1, 0.2}), kSquare);
  HeightTally ab = a, ba = b;
  ab.Add(b);
  ba.Add(a);
  EXPECT_EQ(ab.area_of_bin, ba.area_of_bin);
  EXPECT_EQ(ab.area_of_bin.size(), 3U);
}

TEST(HalfSampleModeTest, NothingHasNone) { EXPECT_EQ(HalfSampleMode({}), std::nullopt); }

TEST(HalfSampleModeTest, LevelSurfaceKeepsItsHeight) {
  EXPECT_EQ(*HalfSampleMode(TallyHeights(Steps({3.25, 3.25, 3.3}), kSquare)), 3.25);
}

TEST(HalfSampleModeTest, FindsWaterBesideABridgeAndTrees) {
  std::mt19937 random(3);
  std::normal_distribution<double> waves(3.25, 0.15);
  HeightTally tally;
  for (int k = 0; k < 4000; ++k) tally.area_of_bin[HeightBinOf(waves(random))] += 1000;
  for (int k = 0; k < 1500; ++k)
    tally.area_of_bin[HeightBinOf(6 + 0.01 * static_cast<double>(random() % 20))] += 1000;  // a deck
  for (int k = 0; k < 1000; ++k)
    tally.area_of_bin[HeightBinOf(4 + 0.01 * static_cast<double>(random() % 800))] += 1000;  // trees
  EXPECT_NEAR(*HalfSampleMode(tally), 3.25, 0.1);
}

TEST(LowerHalfTest, EndsWithinABin) {
  const HeightTally half = LowerHalf({{{3, 4}, {5, 10}, {9, 6}}});
  EXPECT_EQ(half.area_of_bin, (std::map<int32_t, int64_t>{{3, 4}, {5, 6}}));
  EXPECT_TRUE(LowerHalf({}).area_of_bin.empty());
}

TEST(SpreadAboutTest, IsTheDeviationOfNormalHeightsWhateverStandsInThem) {
  std::mt19937 random(3);
  std::normal_distribution<double> waves(-3.25, 0.15);
  HeightTally tally;
  for (int k = 0; k < 4000; ++k) tally.area_of_bin[HeightBinOf(waves(random))] += 1000;
  EXPECT_NEAR(SpreadAbout(tally, -3.25, -1.75), 0.15, 0.01);
  tally.area_of_bin[HeightBinOf(-2)] = 400'000;    // a bank
  tally.area_of_bin[HeightBinOf(20)] = 9'000'000;  // trees
  EXPECT_NEAR(SpreadAbout(tally, -3.25, -1.75), 0.17, 0.02);
  EXPECT_EQ(SpreadAbout({{{HeightBinOf(3.25), 7}}}, 3.25, 4.75), 0);
  EXPECT_EQ(SpreadAbout({{{HeightBinOf(3.25), 7}}}, 3.25, 3), 0);
}

}  // namespace
}  // namespace tilemend
