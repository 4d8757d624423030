#include "worker/fill/region/refine_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/worker/fill/region/refine_quality.h"

namespace tilemend {
namespace {

using testing::AllPoints;
using testing::CheckDelaunay;
using testing::CheckTopology;
using ::testing::IsEmpty;
using testing::Measure;
using ::testing::Not;
using testing::Quality;
using testing::SizedRegion;

constexpr int64_t kSpacing = 20'000;

RefineOptions Uniform() {
  RefineOptions options;
  options.uniform = true;
  return options;
}

// Refines and checks every exact guarantee.
RefinedRegion RefineAndCheck(const SizedRegion& region, const RefineOptions& options) {
  RefinedRegion refined = RefineRegion(region.points, region.segments, region.size, options);
  const std::vector<LatticePoint> points = AllPoints(region, refined);
  CheckTopology(points, region.segments, refined.triangulation);
  if (!::testing::Test::HasFatalFailure()) CheckDelaunay(points, refined.triangulation);
  // Every new point is used, and by a full turn of triangles: none lies on a segment.
  std::set<int32_t> used;
  for (const Triangle& t : refined.triangulation.triangles) used.insert(t.begin(), t.end());
  const auto first_new = used.lower_bound(static_cast<int32_t>(region.points.size()));
  EXPECT_EQ(static_cast<size_t>(std::distance(first_new, used.end())), refined.new_points.size());
  return refined;
}

SizedRegion Polygon(int corners, double edge) {
  SizedRegion region;
  std::vector<LatticePoint> loop;
  const double radius = edge / (2 * std::sin(std::numbers::pi / corners));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    loop.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  region.Loop(loop);
  SetSizesFromSegments(region);
  return region;
}

TEST(RefineRegionTest, NothingGivesNothing) {
  const RefinedRegion refined = RefineRegion({}, {}, {}, {});
  EXPECT_THAT(refined.new_points, IsEmpty());
  EXPECT_THAT(refined.triangulation.conflicts, IsEmpty());
}

TEST(RefineRegionTest, EndsSoonWhenItIsCancelled) {
  const SizedRegion region = Polygon(400, kSpacing);
  RefineOptions options = Uniform();
  const size_t all = RefineRegion(region.points, region.segments, region.size, options).new_points.size();
  int asked = 0;
  options.is_cancelled = [&] { return ++asked == 2; };
  const size_t some = RefineRegion(region.points, region.segments, region.size, options).new_points.size();
  EXPECT_EQ(asked, 2);
  EXPECT_LT(some, all);
}

TEST(RefineRegionTest, ConflictsAreReportedAndNothingElse) {
  SizedRegion region;
  region.Loop({{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}});
  region.size.assign(4, 10);
  const RefinedRegion refined = RefineRegion(region.points, region.segments, region.size, {});
  EXPECT_THAT(refined.triangulation.conflicts, Not(IsEmpty()));
  EXPECT_THAT(refined.triangulation.triangles, IsEmpty());
  EXPECT_THAT(refined.new_points, IsEmpty());
}

TEST(RefineRegionTest, SmallHolesGetNoNeedlessPoints) {
  for (const RefineOptions& options : {RefineOptions(), Uniform()}) {
    EXPECT_EQ(RefineAndCheck(Polygon(3, 50'000), options).new_points.size(), 0u);
    EXPECT_EQ(RefineAndCheck(Polygon(4, 50'000), options).new_points.size(), 0u);
    EXPECT_EQ(RefineAndCheck(Polygon(5, 50'000), options).new_points.size(), 1u);
    EXPECT_EQ(RefineAndCheck(Polygon(6, 50'000), options).new_points.size(), 1u);
    EXPECT_LE(RefineAndCheck(Polygon(8, 50'000), options).new_points.size(), 3u);
  }
}

TEST(RefineRegionTest, UniformQualityOnRivers) {
  for (uint32_t seed = 0; seed < 4; ++seed) {
    const SizedRegion region = testing::River(300, 20 + 10 * seed, kSpacing, 0.15, seed);
    const Quality quality = Measure(region, RefineAndCheck(region, Uniform()));
    EXPECT_GE(quality.mean, 0.972) << seed;
    EXPECT_GE(quality.fifth_percentile, 0.9) << seed;
    EXPECT_GE(quality.least_inside, 0.5) << seed;
  }
}

TEST(RefineRegionTest, GradedQualityOnRivers) {
  for (uint32_t seed = 0; seed < 4; ++seed) {
    const SizedRegion region = testing::River(300, 20 + 10 * seed, kSpacing, 0.15, seed);
    const Quality quality = Measure(region, RefineAndCheck(region, RefineOptions()));
    EXPECT_GE(quality.mean, 0.95) << seed;
    EXPECT_GE(quality.fifth_percentile, 0.84) << seed;
    EXPECT_GE(quality.least_inside, 0.4) << seed;
  }
}

TEST(RefineRegionTest, QualityOnDiscsAndGridSquares) {
  for (const SizedRegion& region : {testing::Disc(40, kSpacing, 0.1, 1), testing::GridSquare(50, kSpacing)}) {
    const Quality uniform = Measure(region, RefineAndCheck(region, Uniform()));
    EXPECT_GE(uniform.mean, 0.965);
    EXPECT_GE(uniform.least, 0.5);
    const Quality graded = Measure(region, RefineAndCheck(region, RefineOptions()));
    EXPECT_GE(graded.mean, 0.95);
    EXPECT_GE(graded.least, 0.4);
  }
}

TEST(RefineRegionTest, UniformKeepsTheSizeOfTheRim) {
  const SizedRegion region = testing::GridSquare(60, kSpacing);
  const RefinedRegion refined = RefineAndCheck(region, Uniform());
  // 3600 cells of side^2, two triangles of sqrt(3) / 4 * side^2 per vertex.
  EXPECT_NEAR(static_cast<double>(refined.new_points.size()), 3600 / std::sqrt(0.75), 350);
}

TEST(RefineRegionTest, GradedGrowsInwardUpToTheLimit) {
  const SizedRegion region = testing::Disc(150, kSpacing, 0.05, 2);
  const size_t uniform = RefineAndCheck(region, Uniform()).new_points.size();
  const RefinedRegion graded = RefineAndCheck(region, RefineOptions());
  EXPECT_LT(graded.new_points.size() * 10, uniform);
  const std::vector<LatticePoint> points = AllPoints(region, graded);
  double longest = 0, near_sum = 0, near_count = 0;
  for (const Triangle& t : graded.triangulation.triangles) {
    for (int k = 0; k < 3; ++k) {
      const double length = testing::Distance(points[t[k]], points[t[(k + 1) % 3]]);
      longest = std::max(longest, length);
      const auto on_rim = [&](int i) { return t[i] < static_cast<int32_t>(region.points.size()); };
      if (on_rim(k) == on_rim((k + 1) % 3)) continue;
      near_sum += length;
      near_count += 1;
    }
  }
  EXPECT_GT(longest, 8 * kSpacing);
  EXPECT_LT(longest, 16 * 1.6 * kSpacing);
  EXPECT_NEAR(near_sum / near_count, 1.15 * kSpacing, 0.25 * kSpacing);
  RefineOptions tight;
  tight.size_limit = 4;
  EXPECT_GT(RefineAndCheck(region, tight).new_points.size(), graded.new_points.size());
  RefineOptions gentle;
  gentle.gradation = 1.1;
  EXPECT_GT(RefineAndCheck(region, gentle).new_points.size(), graded.new_points.size());
}

TEST(RefineRegionTest, SizesBetweenTwoBanksOfDifferentSpacing) {
  SizedRegion region;
  std::vector<LatticePoint> loop;
  for (int i = 0; i < 60; ++i) loop.push_back({i * 100'000, 0});
  for (int i = 0; i < 20; ++i) loop.push_back({6'000'000, i * 300'000});
  for (int i = 0; i < 20; ++i) loop.push_back({6'000'000 - i * 300'000, 6'000'000});
  for (int i = 0; i < 20; ++i) loop.push_back({0, 6'000'000 - i * 300'000});
  region.Loop(loop);
  SetSizesFromSegments(region);
  for (const RefineOptions& options : {RefineOptions(), Uniform()}) {
    const Quality quality = Measure(region, RefineAndCheck(region, options));
    EXPECT_GE(quality.mean, 0.93);
    EXPECT_GE(quality.least, 0.4);
  }
}

TEST(RefineRegionTest, IslandsPinchesAndSlits) {
  SizedRegion region;
  region.Loop({{0, 0}, {400'000, 0}, {400'000, 400'000}, {0, 400'000}});
  region.Loop({{100'000, 100'000}, {100'000, 150'000}, {150'000, 150'000}, {150'000, 100'000}});
  region.points.push_back({450'000, 350'000});
  region.points.push_back({450'000, 450'000});
  region.LoopOf({2, 8, 9});  // pinched at a corner
  region.points.push_back({200'000, 300'000});
  region.points.push_back({300'000, 300'000});
  region.LoopOf({10, 11});  // a slit
  region.size.assign(region.points.size(), 30'000);
  for (const RefineOptions& options : {RefineOptions(), Uniform()}) {
    const RefinedRegion refined = RefineAndCheck(region, options);
    EXPECT_EQ(refined.triangulation.component_count, 2);
    EXPECT_GT(refined.new_points.size(), 12u);
  }
}

TEST(RefineRegionTest, FreePointsStayAndHaveNoSizeOfTheirOwn) {
  SizedRegion region = testing::GridSquare(20, kSpacing);
  const size_t without = RefineAndCheck(region, Uniform()).new_points.size();
  region.points.push_back({10 * kSpacing + 77, 10 * kSpacing});
  region.size.push_back(1);
  const RefinedRegion refined = RefineAndCheck(region, Uniform());
  EXPECT_NEAR(static_cast<double>(refined.new_points.size()), static_cast<double>(without), 25);
  const auto free_point = static_cast<int32_t>(region.points.size()) - 1;
  EXPECT_TRUE(std::ranges::any_of(refined.triangulation.triangles,
                                  [&](const Triangle& t) { return std::ranges::count(t, free_point) > 0; }));
}

TEST(RefineRegionTest, VeryUnevenRimsStayValid) {
  SizedRegion region;
  region.Loop({{0, 0}, {20'000'000, 0}, {20'000'000, 20'000'000}, {0, 20'000'000}});
  std::vector<LatticePoint> island;
  for (int i = 40; i > 0; --i) {
    const double angle = i * std::numbers::pi / 20;
    island.push_back(
        {8'000'000 + std::llround(1e6 * std::cos(angle)), 8'000'000 + std::llround(1e6 * std::sin(angle))});
  }
  region.Loop(island);
  SetSizesFromSegments(region);
  for (const RefineOptions& options : {RefineOptions(), Uniform()}) {
    EXPECT_GE(Measure(region, RefineAndCheck(region, options)).mean, 0.8);
  }
}

TEST(RefineRegionTest, RandomStarsStayValid) {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    SizedRegion region;
    static_cast<testing::Region&>(region) =
        testing::RandomStar(seed, 3 + static_cast<int>(seed % 60), seed % 3 == 0 ? 300 : 2e8);
    SetSizesFromSegments(region);
    RefineAndCheck(region, seed % 2 == 0 ? Uniform() : RefineOptions());
    if (HasFatalFailure()) return;
  }
}

TEST(RefineRegionTest, AnySizesAndOptionsEndAndStayValid) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SizedRegion region = testing::GridSquare(12, 100);
  for (double size : {kNan, kInfinity, -kInfinity, 0.0, -5.0, 1e-300, 1e300, 20.0}) {
    for (double ratio : {kNan, kInfinity, 0.0, 1.0, 1e300}) {
      region.size.assign(region.points.size(), 100);
      for (size_t i = 0; i < region.size.size(); i += 5) region.size[i] = size;
      RefineOptions options;
      options.gradation = ratio;
      RefineAndCheck(region, options);
      options.gradation = 1.3;
      options.size_limit = ratio;
      RefineAndCheck(region, options);
    }
  }
  EXPECT_THAT(RefineRegion(region.points, region.segments, {}, {}).triangulation.conflicts, IsEmpty());
}

TEST(RefineRegionTest, StopsAtTheLargestNumberOfNewPoints) {
  RefineOptions options = Uniform();
  options.max_new_points = 17;
  EXPECT_EQ(RefineAndCheck(testing::GridSquare(30, kSpacing), options).new_points.size(), 17u);
  options.max_new_points = 0;
  EXPECT_EQ(RefineAndCheck(testing::GridSquare(30, kSpacing), options).new_points.size(), 0u);
}

TEST(RefineRegionTest, NearlyCollinearThinRegion) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int64_t> off(-100, 100);
  std::vector<LatticePoint> loop;
  const int n = 1000;
  for (int i = 0; i < n; ++i) loop.push_back({i * 100'000, off(random)});
  for (int i = n; i > 0; --i) loop.push_back({i * 100'000 + 40'000, 300'000 + off(random)});
  SizedRegion region;
  region.Loop(loop);
  SetSizesFromSegments(region);
  EXPECT_GE(Measure(region, RefineAndCheck(region, Uniform())).mean, 0.9);
}

TEST(RefineRegionTest, MovingChangesNothingButThePlace) {
  const SizedRegion region = testing::River(100, 15, kSpacing, 0.15, 9);
  SizedRegion moved = region;
  for (LatticePoint& p : moved.points) p = {p.x + 1'234'567, p.y - 7'654'321};
  const RefinedRegion a = RefineAndCheck(region, RefineOptions()), b = RefineAndCheck(moved, RefineOptions());
  EXPECT_EQ(a.new_points.size(), b.new_points.size());
  EXPECT_NEAR(Measure(region, a).mean, Measure(moved, b).mean, 0.002);
}

TEST(RefineRegionTest, TurningKeepsTheQuality) {
  const SizedRegion region = testing::River(150, 25, kSpacing, 0.15, 10);
  SizedRegion turned = region;
  for (LatticePoint& p : turned.points) p = {-p.y, p.x};
  const Quality a = Measure(region, RefineAndCheck(region, RefineOptions()));
  const Quality b = Measure(turned, RefineAndCheck(turned, RefineOptions()));
  EXPECT_NEAR(a.mean, b.mean, 0.01);
  EXPECT_NEAR(static_cast<double>(a.triangles), static_cast<double>(b.triangles),
              0.05 * static_cast<double>(a.triangles));
}

// In the order of refinement, round the rim, the mean step is 18 spacings.
TEST(RefineRegionTest, NumbersNewPointsByPlace) {
  const SizedRegion region = testing::River(400, 60, kSpacing, 0.15, 12);
  RefineOptions uniform;
  uniform.uniform = true;
  const RefinedRegion refined = RefineAndCheck(region, uniform);
  double sum = 0;
  for (size_t i = 1; i < refined.new_points.size(); ++i) {
    const LatticePoint a = refined.new_points[i - 1], b = refined.new_points[i];
    sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
  }
  EXPECT_LT(sum / static_cast<double>(refined.new_points.size()), 3 * kSpacing);
}

TEST(RefineRegionTest, IsDeterministic) {
  const SizedRegion region = testing::River(200, 25, kSpacing, 0.2, 11);
  const RefinedRegion a = RefineRegion(region.points, region.segments, region.size, {});
  const RefinedRegion b = RefineRegion(region.points, region.segments, region.size, {});
  EXPECT_EQ(a.new_points, b.new_points);
  EXPECT_EQ(a.triangulation.triangles, b.triangulation.triangles);
}

}  // namespace
}  // namespace tilemend
