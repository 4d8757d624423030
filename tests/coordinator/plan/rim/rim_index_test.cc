#include "coordinator/plan/rim/rim_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/rim_builders.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

Point2 At(const Rim& rim, int32_t point) { return rim.points[point].position.head<2>(); }

Rim RimOfScene() {
  SceneMakerOptions options;
  options.cols = options.rows = 2;
  options.cut = Cut::kRagged;
  options.lakes = options.islands = true;
  options.small_per_cell = 3;
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  return BuildRim(scene.Input());
}

double DistanceToEdge(const Rim& rim, const Point2& p, const RimEdge& e) {
  const Point2 a = At(rim, e.from), d = At(rim, e.to) - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-30), 0.0, 1.0);
  return (p - a - t * d).norm();
}

// Against a search over all edges, at places all over the scene.
class RimIndexTest : public testing::Test {
 protected:
  template <typename Check>
  void AtManyPlaces(const Check& check) const {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-20, 120);
    for (int i = 0; i < 100; ++i) check(Point2(place(random), place(random)));
  }

  const Rim rim_ = RimOfScene();
  const RimIndex index_{rim_};
};

TEST_F(RimIndexTest, FindsAllEdgesInABoxOnceAndInOrder) {
  AtManyPlaces([&](const Point2& p) {
    const Point2 lo = p - Point2(9, 4), hi = p + Point2(3, 8);
    const std::vector<int32_t> found = index_.EdgesIn(lo, hi);
    EXPECT_LT(found.size(), rim_.edges.size());
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (size_t e = 0; e < rim_.edges.size(); ++e) {
      const Point2 a = At(rim_, rim_.edges[e].from), b = At(rim_, rim_.edges[e].to);
      const bool meets = (a.cwiseMin(b).array() <= hi.array()).all() && (a.cwiseMax(b).array() >= lo.array()).all();
      EXPECT_TRUE(!meets || std::binary_search(found.begin(), found.end(), static_cast<int32_t>(e)));
    }
  });
}

TEST_F(RimIndexTest, MeasuresTheDistanceToTheNearestEdge) {
  AtManyPlaces([&](const Point2& p) {
    double nearest = 15;
    for (const RimEdge& e : rim_.edges) nearest = std::min(nearest, DistanceToEdge(rim_, p, e));
    EXPECT_DOUBLE_EQ(index_.Distance(p, 15), nearest);
  });
}

TEST_F(RimIndexTest, FindsTheNearestPoint) {
  AtManyPlaces([&](const Point2& p) {
    double nearest = 10;
    for (const RimEdge& e : rim_.edges) nearest = std::min(nearest, (At(rim_, e.from) - p).norm());
    const int32_t found = index_.NearestPoint(p, 10);
    EXPECT_EQ(found >= 0, nearest < 10);
    if (found < 0) return;
    EXPECT_DOUBLE_EQ((At(rim_, found) - p).norm(), nearest);
  });
}

TEST_F(RimIndexTest, LetsSizesGrowWithTheDistanceFromTheRim) {
  AtManyPlaces([&](const Point2& p) {
    double least = 30;
    for (const RimEdge& e : rim_.edges) {
      least = std::min(least, rim_.points[e.from].size + 0.3 * (At(rim_, e.from) - p).norm());
    }
    EXPECT_DOUBLE_EQ(index_.SizeAt(p, 0.3, 30), least);
  });
}

TEST_F(RimIndexTest, FindsTheEdgeBetweenTwoPointsEitherWayRound) {
  for (size_t e = 0; e < rim_.edges.size(); ++e) {
    EXPECT_EQ(index_.EdgeBetween(rim_.edges[e].from, rim_.edges[e].to), static_cast<int32_t>(e));
    EXPECT_EQ(index_.EdgeBetween(rim_.edges[e].to, rim_.edges[e].from), static_cast<int32_t>(e));
  }
  const int32_t one = rim_.edges[rim_.loops.at(0)[0]].from, another = rim_.edges[rim_.loops.at(1)[0]].from;
  EXPECT_EQ(index_.EdgeBetween(one, another), -1);
}

TEST_F(RimIndexTest, KnowsTheMeanLengthOfTheEdgesFromAbove) {
  double sum = 0;
  for (const RimEdge& e : rim_.edges) sum += (At(rim_, e.to) - At(rim_, e.from)).norm();
  EXPECT_DOUBLE_EQ(index_.mean_size(), sum / static_cast<double>(rim_.edges.size()));
}

TEST(RimIndexSurfaceTest, TellsSurfaceFromHolesAndFromWhatLiesAround) {
  const std::vector<std::string> picture = {"########", "#......#", "#.##...#", "#.##...#",
                                            "#......#", "########", "###.####", "########"};
  const SurveyedScene scene = PictureScene(picture, 8);
  const Rim rim = BuildRim(scene.Input());
  const RimIndex index(rim);
  for (int32_t row = 0; row < 8; ++row) {
    for (int32_t col = 0; col < 8; ++col) {
      EXPECT_EQ(index.InSurface(Point2(col + 0.4, row + 0.3), 1e-6), picture[7 - row][col] == '#') << col << " " << row;
    }
  }
  EXPECT_FALSE(index.InSurface(Point2(-0.5, 4), 1e-6));
  EXPECT_FALSE(index.InSurface(Point2(9, 4), 1e-6));
  EXPECT_TRUE(index.InSurface(Point2(-0.05, 4), 0.1)) << "within the tolerance of the rim";
}

// A square hole, clockwise, with a spike of surface into it from the north.
Rim SpikedHole() {
  return RimOf({{{0, 0, 0}, {0, 10, 0}, {4, 10, 0}, {5, 4, 0}, {6, 10, 0}, {10, 10, 0}, {10, 0, 0}}});
}

bool IsFree(const Rim& rim, int32_t a, int32_t b) { return RimIndex(rim).IsFree(At(rim, a), a, At(rim, b), b); }

TEST(IsFreeTest, HoldsForSegmentsThroughTheHole) {
  const Rim rim = SpikedHole();
  EXPECT_TRUE(IsFree(rim, 0, 3));
  EXPECT_TRUE(IsFree(rim, 3, 6));
  EXPECT_TRUE(RimIndex(rim).IsFree({1, 1}, -1, {9, 1}, -1));
}

TEST(IsFreeTest, DoesNotHoldAcrossTheRim) {
  const Rim rim = SpikedHole();
  EXPECT_FALSE(IsFree(rim, 1, 5)) << "along the rim on one side and through the spike";
  EXPECT_FALSE(RimIndex(rim).IsFree({1, 8}, -1, {9, 8}, -1));
  EXPECT_FALSE(RimIndex(rim).IsFree({1, 4}, -1, {9, 4}, -1)) << "touches the tip";
}

TEST(IsFreeTest, DoesNotHoldAlongAnEdgeOrIntoTheSurface) {
  const Rim rim = SpikedHole();
  EXPECT_FALSE(IsFree(rim, 0, 1));
  EXPECT_FALSE(IsFree(rim, 2, 4)) << "through the spike's base";
}

TEST(IsFreeTest, DoesNotDependOnTheDirection) {
  const Rim rim = SpikedHole();
  for (int32_t a = 0; a < 7; ++a) {
    for (int32_t b = 0; b < a; ++b) EXPECT_EQ(IsFree(rim, a, b), IsFree(rim, b, a)) << a << " " << b;
  }
}

TEST(RimIndexEmptyTest, AnswersWithoutARim) {
  const Rim rim;
  const RimIndex index(rim);
  EXPECT_TRUE(index.EdgesIn({-1, -1}, {1, 1}).empty());
  EXPECT_EQ(index.NearestPoint({0, 0}, 5), -1);
  EXPECT_EQ(index.Distance({0, 0}, 5), 5);
  EXPECT_FALSE(index.InSurface({0, 0}, 0.1));
}

}  // namespace
}  // namespace tilemend
