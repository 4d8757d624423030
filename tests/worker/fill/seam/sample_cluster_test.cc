#include "worker/fill/seam/sample_cluster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "worker/fill/fill_holes.h"

namespace tilemend {
namespace {

int32_t Add(CellHoles& work, const Point3& position, bool seam) {
  const auto index = static_cast<int32_t>(work.vertices.size());
  RimVertex v;
  v.position = position;
  v.size = 1;
  (seam ? v.seam_vertex : v.index) = index;
  v.height_known = !seam;
  work.vertices.push_back(v);
  return index;
}

void Join(CellHole& hole, const std::vector<int32_t>& way, bool is_seam) {
  for (size_t k = 1; k < way.size(); ++k) hole.segments.push_back({way[k - 1], way[k], is_seam});
}

// Two holes, west and east of a seam at x = 5 from y = 0 to y = 10, in a level surface at height 3, with rim edges of
// 1 m. `steps` vertical edges of 1 mm in the west side.
CellHoles Cluster(int steps) {
  CellHoles work;
  work.lattice_step = 0x1p-10;
  const auto add = [&](double x, double y, double z, bool seam) { return Add(work, Point3(x, y, z), seam); };
  std::vector<int32_t> south_west, south_east, north_east, north_west, seam;
  for (int k = 5; k >= 0; --k) north_west.push_back(add(k, 10, 3, false));
  for (int k = 9; k > 0; --k) {
    north_west.push_back(add(0, k, 3, false));
    if (k <= steps) north_west.push_back(add(0, k, 3.001, false));
  }
  for (int k = 0; k <= 5; ++k) south_west.push_back(add(k, 0, 3, false));
  for (int k = 6; k <= 10; ++k) south_east.push_back(add(k, 0, 3, false));
  for (int k = 1; k <= 10; ++k) south_east.push_back(add(10, k, 3, false));
  for (int k = 9; k > 5; --k) north_east.push_back(add(k, 10, 3, false));
  for (int k = 1; k < 10; ++k) seam.push_back(add(5, k, 0, true));

  CellHole west, east;
  std::vector<int32_t> up = {south_west.back()};
  up.insert(up.end(), seam.begin(), seam.end());
  up.push_back(north_west.front());
  std::vector<int32_t> rim = north_west;
  rim.insert(rim.end(), south_west.begin(), south_west.end());
  Join(west, rim, false);
  Join(west, up, true);
  rim = {south_west.back()};
  rim.insert(rim.end(), south_east.begin(), south_east.end());
  rim.insert(rim.end(), north_east.begin(), north_east.end());
  rim.push_back(north_west.front());
  Join(east, rim, false);
  Join(east, {up.rbegin(), up.rend()}, true);
  work.holes = {west, east};
  for (const RimVertex& v : work.vertices) work.band.points.push_back(v.position);
  return work;
}

FillOptions Untaut() {
  FillOptions options;
  options.tension = 0;
  return options;
}

TEST(SampleClusterTest, GivesASeamInALevelSurfaceItsHeight) {
  const auto surface = SampleCluster(Cluster(0), Untaut());
  ASSERT_TRUE(surface.has_value());
  ASSERT_GE(surface->samples.size(), 9U);
  for (const auto& sample : surface->samples) EXPECT_NEAR(sample.height, 3, 1e-6);
}

TEST(SampleClusterTest, DoesSoWhereTheBoundaryHasVerticalEdges) {
  const auto surface = SampleCluster(Cluster(3), Untaut());
  ASSERT_TRUE(surface.has_value());
  ASSERT_GE(surface->samples.size(), 9U);
  for (const auto& sample : surface->samples) EXPECT_NEAR(sample.height, 3, 0.01);
}

// A bay of the western rim crosses itself. The straight line that cuts it off passes through an island.
TEST(SampleClusterTest, CutsFoldsOffWhereThatMakesNewCrossings) {
  CellHoles cluster = Cluster(0);
  const auto move = [&](double y, const Point3& to) {
    std::ranges::find_if(cluster.vertices, [&](const RimVertex& v) {
      return v.position.x() == 0 && v.position.y() == y;
    })->position = to;
  };
  move(6, {-3, 4.8, 3});
  move(5, {-3.2, 5, 3});
  move(4, {-3, 5.2, 3});
  std::vector<int32_t> island;
  for (const Point2& p : {Point2(-0.7, 5), Point2(-0.2, 5.5), Point2(0.3, 5), Point2(-0.2, 4.5)}) {
    island.push_back(Add(cluster, {p.x(), p.y(), 3}, false));
  }
  island.push_back(island.front());
  Join(cluster.holes[0], island, false);
  cluster.band.points.clear();
  for (const RimVertex& v : cluster.vertices) cluster.band.points.push_back(v.position);
  const auto surface = SampleCluster(cluster, Untaut());
  ASSERT_TRUE(surface.has_value());
  ASSERT_GE(surface->samples.size(), 9U);
  for (const auto& sample : surface->samples) EXPECT_NEAR(sample.height, 3, 1e-6);
}

// A corner of the western rim lies beyond the seam: seen from above the two bound nothing.
TEST(SampleClusterTest, ARimThatCrossesTheSeamHasNoSurface) {
  CellHoles cluster = Cluster(0);
  std::find_if(cluster.vertices.begin(), cluster.vertices.end(), [](const RimVertex& v) {
    return v.position.x() == 0 && v.position.y() == 5;
  })->position.x() = 7;
  EXPECT_FALSE(SampleCluster(cluster, {}).has_value());
}

// As where water ends at a grid line, also where the seam is thinned.
// The cluster in a level street: a house in the west, and every third vertex of the rest of the rim is the foot of a
// wall.
CellHoles Street() {
  CellHoles work = Cluster(0);
  for (size_t i = 0; i < work.vertices.size(); ++i) {
    RimVertex& v = work.vertices[i];
    v.seam_vertex = static_cast<int32_t>(i);
    if (v.index < 0) continue;
    v.on_object = v.position.x() == 0;
    v.on_ground = !v.on_object;
    v.position.z() += v.on_object ? 9 : i % 3 == 0 ? 0.4 : 0;
    work.band.points[i] = v.position;
  }
  for (const CellHole& hole : work.holes) {
    for (const RimSegment& s : hole.segments) {
      if (s.seam) continue;
      const Point3 &a = work.vertices[s.from].position, &b = work.vertices[s.to].position;
      const auto beside = static_cast<int32_t>(work.band.points.size());
      work.band.points.emplace_back((a.x() + b.x()) / 2 + (b.y() - a.y()), (a.y() + b.y()) / 2 - (b.x() - a.x()), 3);
      work.band.triangles.push_back({s.to, s.from, beside});
    }
  }
  return work;
}

TEST(SampleClusterTest, GivesGroundWithWallsAStreetsHeightUnderTheWholeRim) {
  const CellHoles street = Street();
  const auto surface = SampleCluster(street, {});
  ASSERT_TRUE(surface.has_value());
  EXPECT_TRUE(surface->hold_out->walls.is_told());
  EXPECT_EQ(surface->samples.size(), street.vertices.size());
  for (const SurfaceSample& s : surface->samples) {
    const bool on_seam = street.vertices[s.seam_vertex].index < 0;
    EXPECT_NEAR(s.height, 3, on_seam ? 0.1 : 0.15) << s.seam_vertex;
  }
  FillOptions fixed;
  fixed.tension = 1;
  const auto plate = SampleCluster(street, fixed);
  ASSERT_TRUE(plate.has_value());
  EXPECT_LT(plate->samples.size(), street.vertices.size()) << "under objects and along the seam alone";
}

TEST(SampleClusterTest, AHoleInOneCellChoosesGroundWithWallsItself) {
  CellHoles cell = Street();
  CellHole whole{.in_ground = true};
  for (const CellHole& hole : cell.holes) {
    std::ranges::copy_if(hole.segments, std::back_inserter(whole.segments),
                         [](const RimSegment& s) { return !s.seam; });
  }
  cell.holes = {whole};
  const std::vector<HolePatch> patches = FillHoles(cell, {});
  ASSERT_EQ(patches.size(), 1U);
  EXPECT_EQ(patches[0].failure, "");
  ASSERT_TRUE(patches[0].hold_out.has_value());
  EXPECT_TRUE(patches[0].hold_out->walls.is_told());
  EXPECT_FALSE(patches[0].new_points.empty());
  for (const Point3& p : patches[0].new_points) EXPECT_NEAR(p.z(), 3, 0.15) << p.transpose();
}

TEST(SampleClusterTest, ACellOfGroundWithWallsHasTheSurfaceOfTheCluster) {
  CellHoles cell = Street();
  const auto surface = SampleCluster(cell, {});
  ASSERT_TRUE(surface.has_value());
  for (const SurfaceSample& s : surface->samples) {
    RimVertex& v = cell.vertices[s.seam_vertex];
    if (v.index >= 0) {
      v.ground = s.height;
    } else {
      v.position.z() = s.height;
      v.height_known = true;
    }
  }
  for (CellHole& hole : cell.holes) {
    hole.open = true;
    hole.tension = surface->hold_out->tension;
    hole.walls = surface->hold_out->walls;
  }
  const std::vector<HolePatch> patches = FillHoles(cell, {});
  ASSERT_EQ(patches.size(), 2U);
  for (const HolePatch& patch : patches) {
    EXPECT_EQ(patch.failure, "");
    EXPECT_FALSE(patch.new_points.empty());
    for (const Point3& p : patch.new_points) EXPECT_NEAR(p.z(), 3, 0.15) << p.transpose();
  }
}

TEST(SampleClusterTest, KnownHeightsOfASeamStay) {
  CellHoles cluster = Cluster(0);
  for (RimVertex& v : cluster.vertices) {
    if (v.seam_vertex < 0) continue;
    v.height_known = true;
    v.position.z() = 2;
  }
  for (const int64_t most_unknowns : {1000, 20}) {
    const auto surface = SampleCluster(cluster, Untaut(), most_unknowns);
    ASSERT_TRUE(surface.has_value());
    int64_t known = 0;
    for (const auto& sample : surface->samples) {
      if (sample.seam_vertex < 0 || cluster.vertices[sample.seam_vertex].index >= 0) continue;
      EXPECT_EQ(sample.height, 2);
      ++known;
    }
    EXPECT_EQ(known, 9);
  }
}

// As where the edge of the area runs along a grid line.
TEST(SampleClusterTest, GivesANewVertexOfTheRimThatNoSeamEndsAtItsHeight) {
  CellHoles cluster = Cluster(0);
  RimVertex& lone = *std::find_if(cluster.vertices.begin(), cluster.vertices.end(),
                                  [](const RimVertex& v) { return v.position.x() == 8 && v.position.y() == 0; });
  std::swap(lone.seam_vertex, lone.index);
  lone.height_known = false;
  const auto surface = SampleCluster(cluster, Untaut());
  ASSERT_TRUE(surface.has_value());
  const auto sample = std::find_if(surface->samples.begin(), surface->samples.end(),
                                   [&](const SurfaceSample& s) { return s.seam_vertex == lone.seam_vertex; });
  ASSERT_NE(sample, surface->samples.end());
  EXPECT_NEAR(sample->height, 3, 0.01);
}

// As of a tile that reaches far over its grid line: the vertices on its own outline.
TEST(SampleClusterTest, GivesNewVerticesWithoutASegmentTheHeightOfTheSurfaceThere) {
  CellHoles cluster = Cluster(0);
  for (RimVertex& v : cluster.vertices) v.position.z() += 0.5 * v.position.x();
  const int32_t inside = Add(cluster, Point3(7.3, 4.6, 0), true), outside = Add(cluster, Point3(12, 4, 0), true);
  for (size_t v = 0; v < cluster.vertices.size(); ++v) {
    if (v >= cluster.band.points.size()) cluster.band.points.emplace_back();
    cluster.band.points[v] = cluster.vertices[v].position;
  }
  const auto surface = SampleCluster(cluster, Untaut());
  ASSERT_TRUE(surface.has_value());
  const auto sample_of = [&](int32_t v) { return std::ranges::find(surface->samples, v, &SurfaceSample::seam_vertex); };
  ASSERT_NE(sample_of(inside), surface->samples.end());
  EXPECT_NEAR(sample_of(inside)->height, 3 + 0.5 * 7.3, 0.01);
  EXPECT_NEAR(sample_of(inside)->slope.x(), 0.5, 0.01);
  EXPECT_EQ(sample_of(outside), surface->samples.end());
}

}  // namespace
}  // namespace tilemend
