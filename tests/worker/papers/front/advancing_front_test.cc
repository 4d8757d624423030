#include "worker/papers/front/advancing_front.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

// Each edge of the rim has one triangle, each other edge two that run along it in both directions.
void ExpectCloses(const FrontRim& rim, const FrontPatch& patch) {
  ASSERT_TRUE(patch.closed());
  std::map<std::pair<int32_t, int32_t>, int> uses;
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& loop : rim.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ((uses[{loop[i], loop[(i + 1) % loop.size()]}]), 1);
      uses.erase({loop[i], loop[(i + 1) % loop.size()]});
    }
  }
  for (const auto& [edge, n] : uses) {
    EXPECT_EQ(n, 1);
    EXPECT_EQ(uses.count({edge.second, edge.first}), 1u);
  }
}

double MeanQuality(const FrontPatch& patch) {
  double sum = 0;
  for (const Triangle& t : patch.triangles) {
    sum += TriangleQuality(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
  }
  return sum / static_cast<double>(patch.triangles.size());
}

double Area(const FrontPatch& patch) {
  double sum = 0;
  for (const Triangle& t : patch.triangles) sum += TwiceVectorArea(patch.points, t).norm() / 2;
  return sum;
}

double AreaOf(const FrontRim& rim) {
  double sum = 0;
  for (const auto& loop : rim.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      sum += rim.points[loop[i]].cross(rim.points[loop[(i + 1) % loop.size()]]).z() / 2;
    }
  }
  return sum;
}

TEST(AdvancingFrontTest, CoversFlatHolesOfAllSizesOnce) {
  for (const int32_t edges : {3, 4, 5, 6, 10, 16, 41, 126, 300}) {
    for (const double wave : {0.0, 0.3}) {
      const FrontRim rim = FlatRim(edges, wave);
      const FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
      ExpectCloses(rim, patch);
      EXPECT_NEAR(Area(patch), AreaOf(rim), 1e-9 * AreaOf(rim)) << edges;
      if (edges >= 16) {
        EXPECT_GT(MeanQuality(patch), 0.85) << edges;
      }
    }
  }
}

TEST(AdvancingFrontTest, RulesWithCurvatureStayOnASphere) {
  const FrontRim rim = SphereRim(40, 12);
  const FrontPatch patch = AdvanceFront(rim, NormalCurvatureRule({}), EnoughFor(rim));
  ExpectCloses(rim, patch);
  for (const Point3& p : patch.points) EXPECT_NEAR(p.norm(), 12, 0.4);
}

TEST(AdvancingFrontTest, FrontsAroundAnIslandJoin) {
  FrontRim rim = FlatRim(60);
  const auto first = static_cast<int32_t>(rim.points.size());
  std::vector<int32_t> island;
  for (int32_t i = 0; i < 8; ++i) {
    rim.points.emplace_back(1.3 * std::cos(-i * std::numbers::pi / 4), 1.3 * std::sin(-i * std::numbers::pi / 4), 0);
    rim.areas.emplace_back(0, 0, 1);
    rim.neighbours.emplace_back();
    rim.sizes.push_back(1);
    island.push_back(first + i);
  }
  rim.loops.push_back(island);
  rim.may_join = [](int32_t a, int32_t b) { return std::abs(a - b) > 1 && std::abs(a - b) != 59; };
  const FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
  ExpectCloses(rim, patch);
  EXPECT_NEAR(Area(patch), AreaOf(rim), 1e-9 * AreaOf(rim));
}

TEST(AdvancingFrontTest, JoinsNoPointsThatMayNotBeJoined) {
  FrontRim rim = FlatRim(6);
  rim.may_join = [](int32_t, int32_t) { return false; };
  const FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
  ExpectCloses(rim, patch);
  EXPECT_GT(patch.points.size(), rim.points.size());
}

TEST(AdvancingFrontTest, KeepsToTheSizesUnlessCornersDecide) {
  FrontRim rim = FlatRim(24);
  rim.sizes.assign(rim.points.size(), 2.5);
  FrontLimits limits = EnoughFor(rim);
  const FrontPatch by_sizes = AdvanceFront(rim, PlainRule(), limits);
  limits.by_corners = true;
  const FrontPatch by_corners = AdvanceFront(rim, PlainRule(), limits);
  ExpectCloses(rim, by_sizes);
  ExpectCloses(rim, by_corners);
  EXPECT_GT(by_corners.points.size() - rim.points.size(), 2 * (by_sizes.points.size() - rim.points.size()));
}

TEST(AdvancingFrontTest, GivesUpAboveTheMostNewPoints) {
  const FrontRim rim = FlatRim(60);
  FrontLimits limits = EnoughFor(rim);
  limits.most_new_points = 20;
  const FrontPatch patch = AdvanceFront(rim, PlainRule(), limits);
  EXPECT_FALSE(patch.closed());
  EXPECT_TRUE(patch.triangles.empty());
}

TEST(AdvancingFrontTest, GivesUpWhenItGetsTooLong) {
  const FrontRim rim = FlatRim(60);
  FrontLimits limits = EnoughFor(rim);
  limits.longest_front = 59;
  EXPECT_FALSE(AdvanceFront(rim, PlainRule(), limits).closed());
}

TEST(AdvancingFrontTest, EndsWithThatReasonWhenItHasLookedAtTooMuch) {
  const FrontRim rim = FlatRim(60);
  FrontLimits limits = EnoughFor(rim);
  limits.most_looks = 100;
  const FrontPatch patch = AdvanceFront(rim, PlainRule(), limits);
  EXPECT_EQ(patch.end, FrontEnd::kTooMuchWork);
  EXPECT_TRUE(patch.triangles.empty());
}

// Each look at the whole front would take 16 times as many for each point.
TEST(AdvancingFrontTest, LooksAtAsMuchForAPointOfALargeHoleAsOfASmallOne) {
  for (const int32_t edges : {40, 640}) {
    const FrontRim rim = FlatRim(edges);
    FrontLimits limits = EnoughFor(rim);
    limits.most_looks = 40 * edges * edges;
    EXPECT_TRUE(AdvanceFront(rim, PlainRule(), limits).closed()) << edges;
  }
}

TEST(AdvancingFrontTest, EndsWhenItIsCancelled) {
  const FrontRim rim = FlatRim(60);
  FrontLimits limits = EnoughFor(rim);
  limits.is_cancelled = [] { return true; };
  EXPECT_FALSE(AdvanceFront(rim, PlainRule(), limits).closed());
}

}  // namespace
}  // namespace tilemend
