#include "common/assemble/fill_level.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "common/mesh/clear_area.h"

namespace tilemend {
namespace {

constexpr double kSide = 64, kSlope = 0.1;

double Plane(const Point2& p) { return kSlope * p.x(); }

Point2 Middle(const TriMesh& mesh, const Triangle& t) {
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]).head<2>() / 3;
}

// A sloping square of 64 m in squares of `step`, without the triangles whose middles are in the hole.
template <typename InHole>
TriMesh Ground(double step, const InHole& in_hole) {
  const auto n = static_cast<int32_t>(kSide / step);
  TriMesh mesh;
  for (int32_t y = 0; y <= n; ++y) {
    for (int32_t x = 0; x <= n; ++x) mesh.points.emplace_back(x * step, y * step, Plane({x * step, y * step}));
  }
  for (int32_t y = 0; y < n; ++y) {
    for (int32_t x = 0; x < n; ++x) {
      const int32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      for (const Triangle& t : {Triangle{a, b, d}, Triangle{a, d, c}}) {
        if (!in_hole(Middle(mesh, t))) mesh.triangles.push_back(t);
      }
    }
  }
  return mesh;
}

bool InPond(const Point2& p) { return (p - Point2(30, 30)).norm() < 13; }

// Some triangles of a ground that `finest` does not have, as a patch whose own vertices lie at one level.
FilePatch PatchOf(const TriMesh& finest, const TriMesh& taken, double level) {
  std::vector<bool> on_rim(taken.points.size(), false);
  for (const Triangle& t : finest.triangles) {
    for (const int32_t v : t) on_rim[v] = true;
  }
  FilePatch patch;
  std::map<int32_t, int32_t> fresh;
  patch.materials = {{0, "water"}};
  for (Triangle t : taken.triangles) {
    for (int32_t& v : t) {
      if (on_rim[v]) continue;
      const auto next = static_cast<int32_t>(finest.points.size() + patch.new_points.size());
      const auto [at, is_new] = fresh.emplace(v, next);
      if (is_new) patch.new_points.emplace_back(taken.points[v].x(), taken.points[v].y(), level);
      v = at->second;
    }
    patch.triangles.push_back(t);
  }
  patch.like.assign(patch.new_points.size(), -1);
  return patch;
}

FilePatch Pond(const TriMesh& finest, double step, double level) {
  return PatchOf(finest, Ground(step, [](const Point2& p) { return !InPond(p); }), level);
}

// A ground that some areas clear: what stays, and what they take out.
struct ClearedGround {
  ClearedGround(double step, const std::vector<ClearArea>& areas) {
    stays = taken = Ground(step, [](const Point2&) { return false; });
    const std::vector<int32_t> by = AreasThatClear(stays, areas);
    stays.triangles.clear();
    taken.triangles.clear();
    const TriMesh whole = Ground(step, [](const Point2&) { return false; });
    for (size_t t = 0; t < by.size(); ++t) (by[t] < 0 ? stays : taken).triangles.push_back(whole.triangles[t]);
  }
  TriMesh stays, taken;
};

ClearArea Disk(const Point2& middle, double radius) {
  ClearArea area;
  std::vector<Point2> ring;
  for (int k = 0; k < 32; ++k) {
    ring.emplace_back(middle + radius * Point2(std::cos(k * M_PI / 16), std::sin(k * M_PI / 16)));
  }
  area.polygon.rings = {ring};
  area.top = std::numeric_limits<double>::infinity();
  return area;
}

TriMesh Joined(const TriMesh& mesh, const FilePatch& patch) {
  TriMesh joined = mesh;
  joined.points.insert(joined.points.end(), patch.new_points.begin(), patch.new_points.end());
  joined.triangles.insert(joined.triangles.end(), patch.triangles.begin(), patch.triangles.end());
  return joined;
}

// Edges with one triangle.
std::vector<std::pair<int32_t, int32_t>> OpenEdges(const TriMesh& mesh) {
  std::map<std::pair<int32_t, int32_t>, int> count;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++count[std::minmax(t[k], t[(k + 1) % 3])];
  }
  std::vector<std::pair<int32_t, int32_t>> open;
  for (const auto& [edge, n] : count) {
    if (n == 1) open.push_back(edge);
  }
  return open;
}

double AreaOf(const TriMesh& mesh, bool* all_up = nullptr) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point2 u = (mesh.points[t[1]] - mesh.points[t[0]]).head<2>();
    const Point2 v = (mesh.points[t[2]] - mesh.points[t[0]]).head<2>();
    const double twice = u.x() * v.y() - u.y() * v.x();
    if (all_up != nullptr) *all_up = *all_up && twice > 0;
    area += twice / 2;
  }
  return area;
}

TEST(FillLevelTest, ACoarserLevelIsClosedOnItsOwnRim) {
  const TriMesh finest = Ground(0.5, InPond);
  const FilePatch pond = Pond(finest, 0.5, -1);
  for (const double step : {1.0, 2.0, 4.0, 8.0}) {
    const TriMesh level = Ground(step, InPond);
    const FilePatch patch = FillLevel(level, finest, pond).patch;
    ASSERT_FALSE(patch.triangles.empty()) << step;
    bool all_up = true;
    const TriMesh filled = Joined(level, patch);
    EXPECT_NEAR(AreaOf(filled, &all_up), kSide * kSide, 1e-6) << step;
    EXPECT_TRUE(all_up) << step;
    EXPECT_EQ(OpenEdges(filled).size(), static_cast<size_t>(4 * kSide / step)) << "the square's own sides, " << step;
  }
}

TEST(FillLevelTest, WaterHasTheSameLevelToTheBit) {
  const TriMesh finest = Ground(0.5, InPond);
  const double level_metres = -1.0009765625;
  const FilePatch patch = FillLevel(Ground(2, InPond), finest, Pond(finest, 0.5, level_metres)).patch;
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), level_metres);
}

TEST(FillLevelTest, IsAsCoarseAsItsLevel) {
  const TriMesh finest = Ground(0.5, InPond);
  const FilePatch pond = Pond(finest, 0.5, -1);
  size_t before = pond.triangles.size();
  for (const double step : {1.0, 2.0, 4.0}) {
    const size_t now = FillLevel(Ground(step, InPond), finest, pond).patch.triangles.size();
    EXPECT_LT(now, before / 2) << step;
    before = now;
  }
}

TEST(FillLevelTest, KeepsMaterials) {
  const TriMesh finest = Ground(0.5, InPond);
  const FilePatch patch = FillLevel(Ground(2, InPond), finest, Pond(finest, 0.5, -1)).patch;
  ASSERT_EQ(patch.materials.size(), 1u);
  EXPECT_EQ(patch.materials[0].material, "water");
  EXPECT_EQ(patch.like.size(), patch.new_points.size());
}

TEST(FillLevelTest, AHoleAtTheOutlineEndsThere) {
  const auto in_bay = [](const Point2& p) { return (p - Point2(0, 30)).norm() < 13; };
  const TriMesh finest = Ground(0.5, in_bay), level = Ground(2, in_bay);
  const TriMesh whole = Ground(0.5, [](const Point2&) { return false; });
  FilePatch bay;
  for (const Triangle& t : whole.triangles) {
    if (in_bay(Middle(whole, t))) bay.triangles.push_back(t);
  }
  bay.new_points = {};
  const FilePatch patch = FillLevel(level, finest, bay).patch;
  const TriMesh filled = Joined(level, patch);
  EXPECT_NEAR(AreaOf(filled), kSide * kSide, 1e-6);
  for (const Point3& p : patch.new_points) EXPECT_GE(p.x(), 0);
}

TEST(FillLevelTest, WhatWasClearedIsClosedHoweverLargeItsTrianglesAre) {
  const std::vector<ClearArea> areas = {Disk({30.3, 29.1}, 3), Disk({45.2, 48.7}, 5), Disk({10, 50}, 2)};
  const ClearedGround finest(0.5, areas);
  const double water = -1;
  const FilePatch ponds = PatchOf(finest.stays, finest.taken, water);
  for (const double step : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    const ClearedGround level(step, areas);
    const LevelFill fill = FillLevel(level.stays, finest.stays, ponds, level.taken);
    EXPECT_TRUE(fill.open.empty()) << step;
    bool all_up = true;
    const TriMesh filled = Joined(level.stays, fill.patch);
    EXPECT_NEAR(AreaOf(filled, &all_up), kSide * kSide, 1e-6) << step;
    EXPECT_TRUE(all_up) << step;
    EXPECT_EQ(OpenEdges(filled).size(), static_cast<size_t>(4 * kSide / step)) << "the square's own sides, " << step;
    for (const Point3& p : fill.patch.new_points) {
      EXPECT_TRUE(p.z() == water || std::abs(p.z() - Plane(p.head<2>())) < 1e-9) << "beyond a pond the ground stays";
    }
  }
}

TEST(FillLevelTest, WaterThatWasClearedEndsAtItsShore) {
  const std::vector<ClearArea> areas = {Disk({30.3, 29.1}, 13)};
  const ClearedGround finest(0.5, areas), level(4, areas);
  const FilePatch pond = PatchOf(finest.stays, finest.taken, -1);
  const FilePatch patch = FillLevel(level.stays, finest.stays, pond, level.taken).patch;
  double flat = 0;
  for (const Triangle& t : patch.triangles) {
    TriMesh one = Joined(level.stays, patch);
    one.triangles = {t};
    const bool is_flat = std::all_of(t.begin(), t.end(), [&](int32_t v) { return one.points[v].z() == -1; });
    if (is_flat) flat += AreaOf(one);
  }
  EXPECT_GT(flat, 0.7 * M_PI * 13 * 13);
  EXPECT_LT(flat, 1.1 * M_PI * 13 * 13) << "it does not flood what else was cleared";
}

TEST(FillLevelTest, ALevelOfWhichNothingIsLeftIsFilled) {
  const std::vector<ClearArea> areas = {Disk({32, 32}, 100)};
  const ClearedGround finest(0.5, areas), level(8, areas);
  ASSERT_TRUE(level.stays.triangles.empty());
  const FilePatch patch =
      FillLevel(level.stays, finest.stays, PatchOf(finest.stays, finest.taken, -1), level.taken).patch;
  EXPECT_NEAR(AreaOf(Joined(level.stays, patch)), kSide * kSide, 1e-6);
}

TEST(FillLevelTest, WhatTheFinestLevelLeavesOpenStaysOpen) {
  const std::vector<ClearArea> areas = {Disk({16.3, 16.1}, 6), Disk({46.2, 46.7}, 8)};
  const ClearedGround finest(0.5, areas), filled(0.5, {areas[0]}), left(0.5, {areas[1]}), level(2, areas);
  const FilePatch patch =
      FillLevel(level.stays, finest.stays, PatchOf(finest.stays, filled.taken, -1), level.taken).patch;
  const double hole = AreaOf(left.taken);
  EXPECT_NEAR(kSide * kSide - AreaOf(Joined(level.stays, patch)), hole, 0.25 * hole);
}

// One triangle of the level is open. The patch covers less than a tenth of it, and not its middle.
TEST(FillLevelTest, AHoleThatIsMuchLargerThanThePatchIsClosed) {
  const auto in_puddle = [](const Point2& p) { return (p - Point2(30, 30)).norm() < 3; };
  const auto is_open = [](const Point2& p) { return (p - Point2(16 + 32.0 / 3, 16 + 16.0 / 3)).norm() < 1; };
  const TriMesh finest = Ground(0.5, in_puddle), level = Ground(16, is_open);
  ASSERT_NEAR(AreaOf(level), kSide * kSide - 128, 1e-6);
  const FilePatch puddle = PatchOf(finest, Ground(0.5, [&](const Point2& p) { return !in_puddle(p); }), -1);
  const LevelFill fill = FillLevel(level, finest, puddle);
  EXPECT_NEAR(AreaOf(Joined(level, fill.patch)), kSide * kSide, 1e-6);
  EXPECT_THAT(fill.open, ::testing::IsEmpty());
}

TEST(FillLevelTest, NothingToFillGivesNothing) {
  const TriMesh finest = Ground(0.5, InPond);
  const FilePatch pond = Pond(finest, 0.5, -1);
  EXPECT_TRUE(FillLevel(Ground(4, [](const Point2&) { return false; }), finest, pond).patch.triangles.empty());
  EXPECT_TRUE(FillLevel(Ground(4, InPond), finest, {}).patch.triangles.empty());
}

}  // namespace
}  // namespace tilemend
