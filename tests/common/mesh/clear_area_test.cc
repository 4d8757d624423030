#include "common/mesh/clear_area.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

const PlanePolygon kSquare{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}};

// One triangle with its right angle at (x, y), `side` long, with these heights at its corners.
void Add(TriMesh& mesh, double x, double y, double side, std::array<double, 3> z) {
  const auto first = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{x, y, z[0]}, {x + side, y, z[1]}, {x, y + side, z[2]}});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

TEST(ClearAreaTest, TakesWhatIsInsideAndLow) {
  TriMesh mesh;
  Add(mesh, 2, 2, 1, {1, 1, 1});      // inside and low
  Add(mesh, 2, 2, 1, {9, 9, 9});      // a deck above it
  Add(mesh, 20, 2, 1, {1, 1, 1});     // outside
  Add(mesh, 2, 2, 1, {1, 1, 2.5});    // a wall that rises above the top stays
  Add(mesh, 2, 2, 1, {-50, -50, 2});  // noise below goes, however deep
  EXPECT_THAT(AreasThatClear(mesh, std::vector<ClearArea>{{kSquare, 2}}), ElementsAre(0, -1, -1, -1, 0));
}

TEST(ClearAreaTest, WithoutATopAllGoes) {
  TriMesh mesh;
  Add(mesh, 2, 2, 1, {1, 1, 100});
  const double all = std::numeric_limits<double>::infinity();
  EXPECT_THAT(AreasThatClear(mesh, std::vector<ClearArea>{{kSquare, all}}), ElementsAre(0));
}

TEST(ClearAreaTest, TheFirstOfSeveralAreasCounts) {
  TriMesh mesh;
  Add(mesh, 2, 2, 1, {1, 1, 1});
  Add(mesh, 2, 2, 1, {4, 4, 4});
  EXPECT_THAT(AreasThatClear(mesh, std::vector<ClearArea>{{kSquare, 2}, {kSquare, 5}}), ElementsAre(0, 1));
}

TEST(ClearAreaTest, OfManyAreasTheFirstOverATriangleCounts) {
  TriMesh mesh;
  std::vector<ClearArea> areas(2000, {kSquare, 2});
  for (int i = 0; i < 2000; ++i) {
    for (Point2& p : areas[i].polygon.rings[0]) p.x() += 10 * (i / 2);
  }
  for (const int at : {1999, 700, 0, 5000}) Add(mesh, 10 * (at / 2) + 2, 2, 1, {1, 1, 1});
  areas[700].top = 0.5;
  EXPECT_THAT(AreasThatClear(mesh, areas), ElementsAre(1998, 701, 0, -1));
}

// A segment that only touches a triangle, or whose line alone passes through it, is not across.
TEST(ClearAreaTest, WhatLiesAcrossTheOutlineOfTheAreaStays) {
  TriMesh mesh;
  Add(mesh, 2, 2, 2, {1, 1, 1});
  const auto by = [&](const PlaneSegment& segment) {
    return AreasThatClear(mesh, std::vector<ClearArea>{{kSquare, 2, {{{-9, -9}, {-9, 20}}, segment}}})[0];
  };
  EXPECT_EQ(by({{2.5, -5}, {2.5, 50}}), -1);
  EXPECT_EQ(by({{2.5, 50}, {2.5, -5}}), -1);
  EXPECT_EQ(by({{2.2, 2.2}, {2.4, 2.3}}), -1) << "within";
  EXPECT_EQ(by({{2.2, 2.2}, {9, 9}}), -1) << "begins within";
  EXPECT_EQ(by({{2, -5}, {2, 50}}), 0) << "along a side";
  EXPECT_EQ(by({{4, 2}, {9, 2}}), 0) << "at a corner";
  EXPECT_EQ(by({{2.5, -5}, {2.5, 1.9}}), 0);
  EXPECT_EQ(by({{3.5, 2.8}, {9, 9}}), 0) << "beyond a side";
}

TEST(ClearAreaTest, UprightTrianglesAreInsideOrNot) {
  TriMesh mesh;
  mesh.points = {{3, 3, 0}, {4, 3, 0}, {3, 3, 1}, {13, 3, 0}, {14, 3, 0}, {13, 3, 1}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_THAT(AreasThatClear(mesh, std::vector<ClearArea>{{kSquare, 2}}), ElementsAre(0, -1));
}

}  // namespace
}  // namespace tilemend
