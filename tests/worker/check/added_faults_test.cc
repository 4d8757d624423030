#include "worker/check/added_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// A sheet with a hole of one square in its middle, and the vertices of that square.
struct Sheet {
  TriMesh mesh = PictureMesh({"###", "#.#", "###"});
  int32_t At(double x, double y) const {
    for (size_t i = 0; i < mesh.points.size(); ++i) {
      if (mesh.points[i].x() == x && mesh.points[i].y() == y) return static_cast<int32_t>(i);
    }
    ADD_FAILURE();
    return 0;
  }
};

AddedFindings Find(const TriMesh& before, const TriMesh& after) {
  const LookedMesh was{before, {}}, is{after, {}};
  return FindAddedFaults(before, after, CompareTiles(was, is));
}

// All that an open edge says but the number of its triangle.
auto TupleOf(const OpenEdge& e) {
  return std::tuple(e.from.x(), e.from.y(), e.from.z(), e.to.x(), e.to.y(), e.to.z(), e.before, e.after, e.is_added,
                    e.is_inner, e.forward);
}

std::vector<decltype(TupleOf({}))> OpenOf(const AddedFindings& found) {
  std::vector<decltype(TupleOf({}))> open;
  for (const OpenEdge& e : found.open) open.push_back(TupleOf(e));
  return open;
}

class AddedFaultsTest : public ::testing::Test {
 protected:
  // The sheet with these triangles, of the corners 0 to 3 of the hole around it, or of further points.
  AddedFindings With(const std::vector<Triangle>& triangles, const std::vector<Point3>& further = {}) {
    const Sheet sheet;
    std::vector<int32_t> number = {sheet.At(1, 1), sheet.At(2, 1), sheet.At(2, 2), sheet.At(1, 2)};
    TriMesh after = before_.mesh;
    for (const Point3& p : further) {
      number.push_back(static_cast<int32_t>(after.points.size()));
      after.points.push_back(p);
    }
    for (const Triangle& t : triangles) after.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    return Find(before_.mesh, after);
  }
  // Corners: numbers of these points.
  void AddOriginals(const std::vector<Point3>& points, const std::vector<Triangle>& triangles) {
    TriMesh& mesh = before_.mesh;
    const auto first = static_cast<int32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    for (const Triangle& t : triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  static int64_t NewOpen(const AddedFindings& found) {
    return std::count_if(found.open.begin(), found.open.end(),
                         [](const OpenEdge& e) { return e.after == 1 && e.before != 1; });
  }

  Sheet before_;
};

TEST_F(AddedFaultsTest, AFilledHoleHasNoFaultAndNoNewOpenEdge) {
  const AddedFindings found = With({{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(NewOpen(found), 0);
  const auto closed = std::count_if(found.open.begin(), found.open.end(),
                                    [](const OpenEdge& e) { return e.before == 1 && e.after == 2; });
  EXPECT_EQ(closed, 4);
}

TEST_F(AddedFaultsTest, AHalfFilledHoleHasANewOpenEdge) { EXPECT_EQ(NewOpen(With({{0, 1, 2}})), 1); }

TEST_F(AddedFaultsTest, ATriangleThatFacesDownTurnsTheEdgesAroundIt) {
  EXPECT_THAT(With({{0, 2, 1}, {0, 2, 3}}).faults.at(AddedFault::kTurnedEdge), SizeIs(3));
}

TEST_F(AddedFaultsTest, AThirdTriangleAtAnEdgeIsNamedOnce) {
  const AddedFindings found = With({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}, {{1.5, 1.5, 5}});
  EXPECT_THAT(found.faults.at(AddedFault::kNonManifoldEdge), SizeIs(1));
}

TEST_F(AddedFaultsTest, OriginalsThatAreThereTwiceCountOnce) {
  Sheet sheet;
  const size_t triangles = sheet.mesh.triangles.size();
  for (size_t t = 0; t < triangles; ++t) {
    const Triangle copied = sheet.mesh.triangles[t];
    sheet.mesh.triangles.push_back({copied[1], copied[2], copied[0]});
  }
  TriMesh after = sheet.mesh;
  const int32_t a = sheet.At(1, 1), b = sheet.At(2, 1), c = sheet.At(2, 2), d = sheet.At(1, 2);
  after.triangles.insert(after.triangles.end(), {{a, b, c}, {a, c, d}});
  EXPECT_THAT(Find(sheet.mesh, after).faults, IsEmpty());
}

TEST_F(AddedFaultsTest, ATriangleWithoutAreaIsNamed) {
  EXPECT_THAT(
      With({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}, {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}).faults.at(AddedFault::kFlatTriangle),
      SizeIs(1));
}

TEST_F(AddedFaultsTest, TellsFillsThatCrossEachOtherFromFillsThatCrossTheSurface) {
  const AddedFindings found = With({{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}, {{1.2, 1.2, -1}, {1.8, 1.3, -1}, {1.5, 1.3, 1}});
  EXPECT_THAT(found.faults.at(AddedFault::kCrossedFill), SizeIs(testing::Ge(2)));
  const AddedFindings outside = With({{4, 5, 6}}, {{0.2, 0.2, -1}, {0.8, 0.3, -1}, {0.5, 0.3, 1}});
  EXPECT_THAT(outside.faults.at(AddedFault::kCrossedSurface), SizeIs(1));
  EXPECT_EQ(outside.faults.count(AddedFault::kCrossedFill), 0U);
}

TEST_F(AddedFaultsTest, NamesTheTriangleAndThoseOfFillsThatItCrosses) {
  const auto originals = static_cast<int32_t>(before_.mesh.triangles.size());
  const AddedFindings found =
      With({{0, 1, 2}, {0, 2, 3}, {4, 4, 5}, {4, 5, 6}}, {{1.5, 1.2, -1}, {1.8, 1.3, -1}, {1.7, 1.3, 1}});
  const std::vector<AddedFaultPlace>& places = found.faults.at(AddedFault::kCrossedFill);
  ASSERT_THAT(places, SizeIs(2));
  EXPECT_EQ(places[0].triangle, originals);
  EXPECT_THAT(places[0].others, testing::ElementsAre(originals + 3)) << "also after a triangle without area";
  EXPECT_EQ(places[1].triangle, originals + 3);
  EXPECT_THAT(places[1].others, testing::ElementsAre(originals));
  EXPECT_EQ(found.faults.at(AddedFault::kFlatTriangle)[0].triangle, originals + 2);
}

TEST_F(AddedFaultsTest, NamesATriangleOfAnEdge) {
  const auto originals = static_cast<int32_t>(before_.mesh.triangles.size());
  const AddedFindings found = With({{0, 2, 1}, {0, 2, 3}});
  for (const AddedFaultPlace& place : found.faults.at(AddedFault::kTurnedEdge)) EXPECT_EQ(place.triangle, originals);
  for (const OpenEdge& e : With({{0, 1, 2}}).open) EXPECT_EQ(e.triangle, e.is_added ? originals : -1);
}

TEST_F(AddedFaultsTest, FaultsOfTheInputAreNoneOfTheOutput) {
  before_.mesh.points.insert(before_.mesh.points.end(), {{0.2, 0.2, -1}, {0.8, 0.3, -1}, {0.5, 0.3, 1}});
  const auto n = static_cast<int32_t>(before_.mesh.points.size());
  before_.mesh.triangles.push_back({n - 3, n - 2, n - 1});
  EXPECT_THAT(With({{0, 1, 2}, {0, 2, 3}}).faults, IsEmpty());
}

TEST_F(AddedFaultsTest, SurfaceThatPassesThroughTheRimIsAFaultOfTheInput) {
  // Stands across the edge of the hole from (1, 1) to (2, 1).
  before_.mesh.points.insert(before_.mesh.points.end(), {{1.5, 0.9, -1}, {1.5, 1.1, -1}, {1.5, 1, 1}});
  const auto n = static_cast<int32_t>(before_.mesh.points.size());
  before_.mesh.triangles.push_back({n - 3, n - 2, n - 1});
  const AddedFindings found = With({{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(found.faults.at(AddedFault::kCrossedRim), SizeIs(1));
  EXPECT_THAT(found.faults, SizeIs(1));
}

TEST_F(AddedFaultsTest, ACurveThatBeginsAtTheRimIsTheInputsToItsEnd) {
  // A fence at x = 1.5 of two triangles: one passes through the edge of the hole, the other goes on inside it.
  AddOriginals({{1.5, 0.9, -1}, {1.5, 0.9, 1}, {1.5, 1.1, 1}, {1.5, 1.4, -1}}, {{0, 2, 1}, {0, 3, 2}});
  const AddedFindings found = With({{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(found.faults.at(AddedFault::kCrossedRim), SizeIs(1));
  EXPECT_THAT(found.faults, SizeIs(1));
}

// The fill is a pit. The same triangle passes through the rim, and once more through the fill where that comes up.
TEST_F(AddedFaultsTest, AnotherCurveThroughTheSameTriangleIsNew) {
  AddOriginals({{1.5, 0.9, -0.2}, {1.5, 0.9, 0.2}, {1.5, 1.97, -0.5}}, {{0, 1, 2}});
  const AddedFindings found = With({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {{1.5, 1.5, -2}});
  EXPECT_THAT(found.faults.at(AddedFault::kCrossedRim), SizeIs(1));
  EXPECT_THAT(found.faults.at(AddedFault::kCrossedSurface), SizeIs(1));
}

int64_t CountOpen(const AddedFindings& found, int32_t before, int32_t after) {
  return std::count_if(found.open.begin(), found.open.end(),
                       [&](const OpenEdge& e) { return e.before == before && e.after == after; });
}

TEST_F(AddedFaultsTest, AnOriginalThatWasTakenOutLeavesOpenEdges) {
  TriMesh after = before_.mesh;
  // One of its edges is at the outline.
  const Triangle gone = after.triangles.front();
  after.triangles.erase(after.triangles.begin());
  const AddedFindings found = Find(before_.mesh, after);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(CountOpen(found, 2, 1), 2);
  EXPECT_EQ(CountOpen(found, 1, 0), 1);
  for (const OpenEdge& e : found.open) {
    if (e.before != 2) continue;
    const auto is_corner = [&](const Point3& p) {
      return std::ranges::any_of(gone, [&](int32_t v) { return before_.mesh.points[v] == p; });
    };
    EXPECT_TRUE(is_corner(e.from) && is_corner(e.to));
    EXPECT_FALSE(e.is_added);
    EXPECT_EQ(e.triangle, -1);
  }
}

TEST_F(AddedFaultsTest, AnOriginalThatWasTakenOutAndFilledAgainIsNoFault) {
  TriMesh after = before_.mesh;
  const Triangle gone = after.triangles.front();
  after.triangles.erase(after.triangles.begin());
  after.triangles.push_back({gone[1], gone[2], gone[0]});  // other corners first: another triangle
  const AddedFindings found = Find(before_.mesh, after);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(CountOpen(found, 2, 1), 0);
  EXPECT_EQ(CountOpen(found, 1, 0), 0);
  EXPECT_EQ(CountOpen(found, 1, 2), 0);
}

TEST_F(AddedFaultsTest, WhatIsFilledAgainCrossesNothingThatWasTakenOut) {
  // A fence stands across one triangle; it is taken out, and the triangle is filled again.
  const Triangle crossed = before_.mesh.triangles.front();
  Point3 middle = Point3::Zero();
  for (const int32_t v : crossed) middle += before_.mesh.points[v] / 3;
  TriMesh after = before_.mesh;
  AddOriginals({middle + Point3(-0.1, 0, -1), middle + Point3(0.1, 0, -1), middle + Point3(0, 0, 1)}, {{0, 1, 2}});
  after.triangles.erase(after.triangles.begin());
  after.triangles.push_back({crossed[1], crossed[2], crossed[0]});
  EXPECT_THAT(Find(before_.mesh, after).faults, IsEmpty());
}

TEST_F(AddedFaultsTest, TheOrderOfTrianglesChangesNothing) {
  TriMesh after = before_.mesh;
  after.triangles.erase(after.triangles.begin() + 2);
  after.triangles.push_back({after.triangles[4][0], after.triangles[4][2], after.triangles[4][1]});
  after.points.insert(after.points.end(), {{0.2, 0.2, -1}, {0.8, 0.3, -1}, {0.5, 0.3, 1}});
  const auto n = static_cast<int32_t>(after.points.size());
  after.triangles.push_back({n - 3, n - 2, n - 1});
  TriMesh turned = after;
  std::ranges::reverse(turned.triangles);
  const AddedFindings found = Find(before_.mesh, after), other = Find(before_.mesh, turned);
  EXPECT_EQ(OpenOf(found), OpenOf(other));
  EXPECT_GT(CountOpen(found, 2, 1), 0);
  ASSERT_EQ(found.faults.size(), other.faults.size());
  EXPECT_GT(found.faults.count(AddedFault::kCrossedSurface), 0U);
  for (const auto& [fault, places] : found.faults) {
    ASSERT_THAT(other.faults.at(fault), SizeIs(places.size()));
    for (const AddedFaultPlace& place : places) {
      EXPECT_TRUE(
          std::ranges::any_of(other.faults.at(fault), [&](const AddedFaultPlace& o) { return o.at == place.at; }));
    }
  }
}

TEST_F(AddedFaultsTest, TrianglesWithoutAnOriginalVertexAreInner) {
  const AddedFindings found = With({{0, 1, 2}, {4, 5, 6}}, {{1.2, 1.2, 3}, {1.8, 1.3, 3}, {1.5, 1.8, 3}});
  EXPECT_EQ(std::count(found.inner.begin(), found.inner.end(), true), 1);
  EXPECT_TRUE(found.inner.back());
}

}  // namespace
}  // namespace tilemend
