#include "worker/weld/weld_rims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/triangle_shape.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

double Wave(double x, double y) { return 0.3 * std::sin(0.7 * x) * std::cos(0.6 * y); }

// Squares of two halves, the right one `off` beside where the left one ends, with `more` vertices in place of one.
TriMesh Halves(const Point3& off, int more = 1, const HeightFunction& height = Wave) {
  const auto all = [](int32_t, int32_t) { return true; };
  TriMesh mesh = SquaresMesh(0, 6, 0, 8, all, height);
  TriMesh right = SquaresMesh(6 * more, 12 * more, 0, 8 * more, all);
  for (Point3& p : right.points) {
    p /= more;
    p.z() = height(p.x(), p.y());
    p += off;
  }
  AddMesh(right, mesh);
  return mesh;
}

Weld WeldOf(const TriMesh& mesh, double tolerance) { return WeldRims(mesh, {}, tolerance, true); }

size_t OpenEdges(const TriMesh& mesh) { return SurveyTile(mesh, false).edges.size(); }

// As the mesh is now: no edge with more than two triangles, or two of one direction; every triangle has area and faces
// as it did; no position is another.
TriMesh ExpectSound(const TriMesh& before, const Weld& weld) {
  std::map<std::pair<int32_t, int32_t>, int> edges;
  TriMesh after{before.points, weld.triangles};
  for (const Triangle& t : Welded(after).triangles) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(++edges[std::pair(t[k], t[(k + 1) % 3])], 1);
  }
  for (size_t t = 0; t < weld.triangles.size(); ++t) {
    const Eigen::Vector3d normal = TwiceVectorArea(before.points, weld.triangles[t]);
    EXPECT_GT(normal.norm(), 0);
    if (t < before.triangles.size()) {
      EXPECT_GT(normal.dot(TwiceVectorArea(before.points, before.triangles[t])), 0);
    }
  }
  return after;
}

TEST(WeldRimsTest, MergesTheTwoSidesOfACrackOntoTheLowerVertex) {
  const TriMesh mesh = Halves({0.04, 0.02, -0.01});
  const Weld weld = WeldOf(mesh, 0.05);
  EXPECT_THAT(weld.record.welded, SizeIs(9));
  for (const WeldedVertex& w : weld.record.welded) {
    EXPECT_LT(w.into, w.vertex);
    EXPECT_NEAR(w.distance, (mesh.points[w.vertex] - mesh.points[w.into]).norm(), 1e-15);
    EXPECT_LE(w.distance, 0.05);
  }
  EXPECT_THAT(weld.record.split, IsEmpty());
  EXPECT_EQ(OpenEdges(mesh), 56u);
  EXPECT_EQ(OpenEdges(ExpectSound(mesh, weld)), 40u);
}

TEST(WeldRimsTest, ChangesNothingBeyondTheTolerance) {
  const TriMesh mesh = Halves({0.04, 0.02, -0.01});
  const Weld weld = WeldOf(mesh, 0.03);
  EXPECT_THAT(weld.record.welded, IsEmpty());
  EXPECT_THAT(weld.record.refused, IsEmpty());
  EXPECT_EQ(weld.triangles, mesh.triangles);
}

TEST(WeldRimsTest, SplitsEdgesWhereVerticesLieBesideThem) {
  for (const int more : {2, 3, 5}) {
    SCOPED_TRACE(more);
    for (const Point3& off : {Point3(0, 0, 0), Point3(0.01, 0.01, 0.01)}) {
      const TriMesh mesh = Halves(off, more, Flat);
      const Weld weld = WeldOf(mesh, 0.05);
      EXPECT_THAT(weld.record.split, SizeIs(static_cast<size_t>(8 * (more - 1))));
      EXPECT_EQ(weld.triangles.size(), mesh.triangles.size() + static_cast<size_t>(8 * (more - 1)));
      ASSERT_THAT(weld.cut_from, SizeIs(static_cast<size_t>(8 * (more - 1))));
      for (size_t k = 0; k < weld.cut_from.size(); ++k) {
        const Triangle &half = weld.triangles[mesh.triangles.size() + k], &whole = mesh.triangles[weld.cut_from[k]];
        EXPECT_TRUE(std::ranges::any_of(half, [&](int32_t v) { return std::ranges::count(whole, v) > 0; })) << k;
      }
      EXPECT_EQ(OpenEdges(ExpectSound(mesh, weld)), static_cast<size_t>(20 + 20 * more));
    }
  }
}

TEST(WeldRimsTest, ClosesRimsThatShareNoVertex) {
  TriMesh mesh = SphereBelt(0, 90, 36);
  TriMesh lower = SphereBelt(0, 90, 31);
  for (Point3& p : lower.points) p = Point3(p.x(), -p.y(), -p.z() - 1e-4);
  AddMesh(lower, mesh);
  const Weld weld = WeldOf(mesh, 0.01);
  EXPECT_EQ(OpenEdges(ExpectSound(mesh, weld)), 0u);
}

TEST(WeldRimsTest, SplitsNoFaceThatHasMoreCornersOrTextures) {
  const TriMesh mesh = Halves({0, 0, 0}, 2, Flat);
  const Weld textured = WeldRims(mesh, {}, 0.05, false);
  EXPECT_THAT(textured.record.split, IsEmpty());
  ASSERT_THAT(textured.record.refused, SizeIs(8));
  EXPECT_THAT(textured.record.refused[0].vertices, SizeIs(3));
  EXPECT_EQ(textured.record.refused[0].reason, "its face has texture coordinates");
  std::vector<int32_t> squares;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) squares.push_back(static_cast<int32_t>(t / 2));
  const Weld polygons = WeldRims(mesh, squares, 0.05, true);
  EXPECT_THAT(polygons.record.split, IsEmpty());
  ASSERT_THAT(polygons.record.refused, SizeIs(8));
  EXPECT_EQ(polygons.record.refused[0].reason, "the face of the edge has more than three corners");
}

TEST(WeldRimsTest, RefusesWhatWouldTakeTheAreaOfAFace) {
  // A needle along the crack: its short edge is within the tolerance.
  TriMesh mesh = Halves({0.04, 0.02, -0.01});
  const auto tip = static_cast<int32_t>(mesh.points.size());
  mesh.points.emplace_back(-0.02, 0, 0.01);
  mesh.triangles.push_back({0, 7, tip});
  const Weld weld = WeldOf(mesh, 0.05);
  EXPECT_THAT(weld.record.welded, SizeIs(9));
  ASSERT_THAT(weld.record.refused, SizeIs(1));
  EXPECT_THAT(weld.record.refused[0].vertices, testing::ElementsAre(0, tip));
  EXPECT_EQ(weld.record.refused[0].reason, "a face would lose its area");
  ExpectSound(mesh, weld);
}

TEST(WeldRimsTest, JoinsNoWallsSides) {
  TriMesh mesh = Halves({1, 0, 0});
  TriMesh below = mesh;
  for (Point3& p : below.points) p.z() -= 0.03;
  for (Triangle& t : below.triangles) std::swap(t[0], t[1]);
  AddMesh(below, mesh);
  const Weld weld = WeldOf(mesh, 0.05);
  EXPECT_THAT(weld.record.welded, IsEmpty());
  EXPECT_THAT(weld.record.split, IsEmpty());
  EXPECT_GE(weld.record.refused.size(), 56u);
  for (const RefusedWeld& r : weld.record.refused) EXPECT_EQ(r.reason, "the surfaces there face opposite ways");
}

TEST(WeldRimsTest, GivesNoEdgeAThirdFace) {
  // Three sheets that meet in a line, nearly.
  TriMesh mesh;
  for (int k = 0; k < 3; ++k) {
    TriMesh sheet = SquaresMesh(0, 4, 0, 5, [](int32_t, int32_t) { return true; });
    const double turn = 1.9 * k;
    for (Point3& p : sheet.points) p = Point3((p.x() + 0.01) * std::cos(turn), p.y(), (p.x() + 0.01) * std::sin(turn));
    if (k == 1) {
      for (Triangle& t : sheet.triangles) std::swap(t[0], t[1]);
    }
    AddMesh(sheet, mesh);
  }
  const Weld weld = WeldOf(mesh, 0.05);
  std::map<std::pair<int32_t, int32_t>, int> edges;
  for (const Triangle& t : weld.triangles) {
    for (int k = 0; k < 3; ++k) EXPECT_LE(++edges[std::minmax(t[k], t[(k + 1) % 3])], 2);
  }
}

TEST(WeldRimsTest, KeepsItsPromisesOnShakenCracks) {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const int more = 1 + static_cast<int>(seed % 3);
    const TriMesh mesh = Shaken(Halves({0, 0, 0}, more), 0.03 * (seed % 7), seed);
    const double tolerance = 0.05 * (1 + seed % 5);
    const Weld weld = WeldOf(mesh, tolerance);
    ExpectSound(mesh, weld);
    for (const WeldedVertex& w : weld.record.welded) EXPECT_LE(w.distance, tolerance);
    // Another time there is nothing left to merge.
    const TriMesh after{mesh.points, weld.triangles};
    EXPECT_LE(WeldOf(after, tolerance).record.welded.size(), weld.record.refused.size());
  }
}

// A triangle over a row of squares, whose corners all lie on its edge.
TEST(WeldRimsTest, ManyVerticesBesideOneEdgeAllSplitIt) {
  constexpr int32_t kMany = 200;
  TriMesh mesh = SquaresMesh(0, kMany, -1, 0, [](int32_t, int32_t) { return true; });
  AddMesh({{{0, 0, 0}, {kMany, 0, 0}, {kMany / 2.0, 90, 0}}, {{0, 1, 2}}}, mesh);
  const Weld weld = WeldOf(mesh, 1e-3);
  EXPECT_THAT(weld.record.split, SizeIs(kMany - 1));
  EXPECT_THAT(weld.record.refused, IsEmpty());
  EXPECT_EQ(OpenEdges(ExpectSound(mesh, weld)), kMany + 4U);
}

}  // namespace
}  // namespace tilemend
