#include "worker/fill/space/live_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using ::testing::DoubleNear;
using ::testing::Gt;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Triangles = std::vector<SpaceTriangle>;

// On few places, so that many have common corners.
Triangles RandomTriangles(size_t count, std::mt19937& random) {
  const auto place = [&] { return static_cast<double>(random() % 4); };
  const auto point = [&] {
    const double x = place(), y = place();
    return Point3(x, y, place());
  };
  Triangles triangles;
  while (triangles.size() < count) {
    const Point3 a = point(), b = point(), c = point();
    if (HasArea({a, b, c})) triangles.push_back({a, b, c});
  }
  return triangles;
}

std::vector<int32_t> CrossedOf(const LiveCrossings& crossings) {
  std::set<int32_t> crossed;
  for (const PatchCrossing& c : crossings.Avoidable()) {
    for (const int32_t t : {c.pair.a, c.pair.b}) {
      if (t >= 0) crossed.insert(t);
    }
  }
  return {crossed.begin(), crossed.end()};
}

TEST(LiveCrossingsTest, FindsWhatAvoidableCrossingsFinds) {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const Triangles surface = RandomTriangles(12, random), earlier = RandomTriangles(3, random),
                    patch = RandomTriangles(6, random);
    EXPECT_EQ(CrossedOf({surface, earlier, patch}), AvoidableCrossings(patch, surface, earlier));
  }
}

TEST(LiveCrossingsTest, IsAfterChangesAsIfMadeAnew) {
  std::mt19937 random(8);
  for (int round = 0; round < 40; ++round) {
    const Triangles surface = RandomTriangles(12, random), patch = RandomTriangles(6, random),
                    in = RandomTriangles(3, random);
    const std::vector<int32_t> out = {0, static_cast<int32_t>(1 + random() % 5)};
    LiveCrossings crossings(surface, {}, patch);
    const double before = crossings.weight();
    const std::vector<int32_t> crossed = CrossedOf(crossings);
    const double expected = crossings.WeightWith(out, in);
    EXPECT_EQ(crossings.weight(), before);
    EXPECT_EQ(CrossedOf(crossings), crossed);
    crossings.Change(out, in);
    EXPECT_THAT(crossings.weight(), DoubleNear(expected, 1e-9));
    Triangles changed;
    for (int32_t t = 0; t < 6; ++t) {
      if (t != out[0] && t != out[1]) changed.push_back(patch[static_cast<size_t>(t)]);
    }
    changed.insert(changed.end(), in.begin(), in.end());
    EXPECT_THAT(LiveCrossings(surface, {}, changed).weight(), DoubleNear(expected, 1e-9));
    crossings.Undo(out, 6);
    EXPECT_THAT(crossings.weight(), DoubleNear(before, 1e-9));
    EXPECT_EQ(CrossedOf(crossings), crossed);
  }
}

TEST(LiveCrossingsTest, WeighsTheLengthOfCurves) {
  const Triangles floor = {{Point3(0, 0, 0), Point3(9, 0, 0), Point3(0, 9, 0)}};
  const auto fin = [](double x) { return SpaceTriangle{Point3(1, 1, -1), Point3(x, 1, -1), Point3(1, 1, 1)}; };
  const LiveCrossings narrow(floor, {}, Triangles{fin(2)}), wide(floor, {}, Triangles{fin(4)});
  EXPECT_THAT(wide.weight() - narrow.weight(), DoubleNear(1, 1e-12)) << "half of the fin is below";
  EXPECT_THAT(wide.weight(), Gt(1.5));
  ASSERT_THAT(wide.Avoidable(), SizeIs(1));
  EXPECT_THAT(wide.Avoidable()[0].points, SizeIs(2));
  EXPECT_LT(wide.Avoidable()[0].pair.a, 0) << "of the surface";
}

TEST(LiveCrossingsTest, PassesOverTrianglesWithoutArea) {
  const Triangles flat = {{Point3(1, 1, -1), Point3(1, 1, 1), Point3(1, 1, 3)}};
  const Triangles floor = {{Point3(0, 0, 0), Point3(9, 0, 0), Point3(0, 9, 0)}};
  EXPECT_THAT(LiveCrossings(flat, flat, floor).Avoidable(), IsEmpty());
}

}  // namespace
}  // namespace tilemend
