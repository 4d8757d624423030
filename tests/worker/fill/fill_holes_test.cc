#include "worker/fill/fill_holes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Picture = std::vector<std::string>;

const Picture kSquareHole = {"##########",  //
                             "##########",  //
                             "##......##",  //
                             "##......##",  //
                             "##......##",  //
                             "##......##",  //
                             "##......##",  //
                             "##......##",  //
                             "##########",  //
                             "##########"};

const Picture kHoleWithIsland = {"##########",  //
                                 "#........#",  //
                                 "#........#",  //
                                 "#..###...#",  //
                                 "#..###...#",  //
                                 "#........#",  //
                                 "#........#",  //
                                 "##########"};

const Picture kPinchedHole = {"########",  //
                              "#...####",  //
                              "#...####",  //
                              "#...####",  //
                              "####...#",  //
                              "####...#",  //
                              "####...#",  //
                              "########"};

// The boundary edges off the outline of a picture.
CellHoles HoleOf(const Picture& picture, const HeightFunction& height = Flat, bool open = false) {
  const auto inside = [&](const Point3& p) {
    return p.x() > 0 && p.y() > 0 && p.x() < static_cast<double>(picture[0].size()) &&
           p.y() < static_cast<double>(picture.size());
  };
  return WorkOf(PictureMesh(picture, height), open,
                [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
}

// The same work with every position moved.
CellHoles MovedWork(CellHoles work, const std::function<Point3(const Point3&)>& f) {
  for (RimVertex& v : work.vertices) v.position = f(v.position);
  for (Point3& p : work.band.points) p = f(p);
  return work;
}

double Waves(double x, double y) { return std::sin(x * 0.7) + 0.5 * std::cos(y * 0.9 + x * 0.2); }

// With either surface.
class FillHolesTest : public testing::TestWithParam<Surface> {
 protected:
  static HolePatch Fill(const CellHoles& work) { return FillHoles(work, With(GetParam())).at(0); }
};
INSTANTIATE_TEST_SUITE_P(Surfaces, FillHolesTest, testing::Values(Surface::kWang, Surface::kThinPlate),
                         [](const auto& test) { return test.param == Surface::kWang ? "Wang" : "ThinPlate"; });

TEST(FillHolesOfThinPlateTest, EndsSoonWhereverItIsCancelled) {
  const CellHoles work = HoleOf(kSquareHole, Waves, true);
  FillOptions options;
  int asked = 0, end = std::numeric_limits<int>::max();
  options.refine.is_cancelled = [&] { return ++asked >= end; };
  const std::vector<HolePatch> patches = FillHoles(work, options);
  ASSERT_TRUE(patches.at(0).failure.empty());
  const int all = asked;
  EXPECT_GT(all, std::ssize(patches[0].new_points)) << "asked for each column of the surface's equations";
  for (end = 1; end <= all; ++end) {
    asked = 0;
    for (const HolePatch& patch : FillHoles(work, options)) EXPECT_FALSE(patch.failure.empty()) << end;
    EXPECT_LE(asked, end + 5);
  }
}

// However the rim runs.
TEST_P(FillHolesTest, WaterIsFlat) {
  for (const bool open : {false, true}) {
    CellHoles work = HoleOf(kHoleWithIsland, Waves, open);
    work.holes[0].level = -0.25;
    const HolePatch patch = Fill(work);
    ExpectClosesHole(work, work.holes[0], patch);
    EXPECT_FALSE(patch.new_points.empty());
    for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), -0.25);
  }
}

TEST_P(FillHolesTest, FillsAPlanarSquareHole) {
  const CellHoles work = HoleOf(kSquareHole);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_NEAR(PatchArea(work, patch), 36, 1e-9);
  EXPECT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), 0);
}

TEST_P(FillHolesTest, PutsNewVerticesOnTheLattice) {
  CellHoles work = HoleOf(kSquareHole, Waves);
  work.lattice_step = 0x1p-4;
  const HolePatch patch = Fill(work);
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_EQ((p * 16).array().round().matrix(), p * 16) << p.transpose();
}

TEST_P(FillHolesTest, NamesOriginalVerticesAndMakesNoneAgain) {
  const CellHoles work = HoleOf(kSquareHole, Waves);
  const HolePatch patch = Fill(work);
  std::set<int32_t> named, made, rim;
  for (const Triangle& t : patch.triangles) {
    for (const int32_t v : t) (v >= 0 ? named : made).insert(v);
  }
  for (const RimSegment& s : work.holes[0].segments) rim.insert(s.from);
  EXPECT_EQ(named, rim);
  EXPECT_EQ(made.size(), patch.new_points.size()) << "each new point is in a triangle";
  for (const Point3& p : patch.new_points) {
    EXPECT_TRUE(p.x() > 2 && p.x() < 8 && p.y() > 2 && p.y() < 8) << "inside the rim: " << p.transpose();
  }
}

TEST_P(FillHolesTest, FacesUpOverAHeightField) {
  const CellHoles work = HoleOf(kSquareHole, Waves, true);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  for (const Triangle& t : patch.triangles) EXPECT_GT(AreaVector2(work, patch, t).z(), 0);
}

// A closed hole in ground of 45 degrees and more (a ring of an elevation model), which a fill in space folds over.
TEST(FillWithAThinPlateTest, DoesNotFoldOverSteepGround) {
  constexpr int32_t kRim = 18;  // its vertices come first
  TriMesh mesh;
  mesh.points = {
      {-6.62, -1.76, 6.03},  {-5.14, -5.97, 7.86}, {-5.09, 0.96, 10.20},  {-5.02, -3.43, 9.63},   {-4.72, 3.36, 7.51},
      {-2.49, 6.27, -0.81},  {-2.47, 3.92, 3.15},  {-1.96, -6.90, 2.76},  {0.23, 6.08, -4.19},    {0.42, -7.15, -0.07},
      {3.19, -6.42, -1.43},  {3.44, 5.59, -7.47},  {3.69, -3.44, 5.20},   {4.97, 6.04, -9.40},    {5.02, -1.36, 6.84},
      {5.45, -3.85, 1.49},   {5.70, 4.14, -6.46},  {6.07, 0.99, 1.58},    {-10.07, -1.03, -3.22}, {-7.64, -3.50, 3.08},
      {-7.53, 2.90, 7.76},   {-7.53, -5.97, 4.99}, {-6.95, 0.93, 6.90},   {-6.46, 6.47, 7.94},    {-4.85, 8.07, 3.31},
      {-4.08, -9.64, -2.74}, {-3.91, 6.07, 2.14},  {-2.68, -9.04, -2.52}, {-1.76, 8.33, -2.54},   {0.09, 8.37, -2.55},
      {0.45, -8.92, -5.38},  {2.61, -9.41, -8.22}, {2.65, 9.07, -2.21},   {5.48, -6.73, -5.98},   {5.59, 8.67, -7.06},
      {7.32, -3.37, -0.61},  {7.37, 3.73, -7.00},  {7.57, 6.51, -12.31},  {8.46, -1.25, 1.40},    {8.66, 1.24, -0.72}};
  mesh.triangles = {{25, 27, 7},  {27, 30, 9},  {30, 31, 9},  {21, 1, 3},   {10, 33, 15}, {19, 3, 0},   {15, 35, 14},
                    {18, 0, 22},  {14, 38, 39}, {22, 2, 4},   {17, 39, 16}, {20, 4, 23},  {4, 6, 5},    {16, 36, 37},
                    {26, 5, 24},  {5, 8, 29},   {8, 11, 32},  {11, 13, 32}, {13, 37, 34}, {25, 1, 21},  {25, 7, 1},
                    {27, 9, 7},   {31, 10, 9},  {31, 33, 10}, {21, 3, 19},  {10, 15, 12}, {33, 35, 15}, {19, 0, 18},
                    {35, 38, 14}, {0, 2, 22},   {14, 39, 17}, {22, 4, 20},  {39, 36, 16}, {4, 26, 23},  {4, 5, 26},
                    {16, 37, 13}, {5, 28, 24},  {5, 29, 28},  {8, 32, 29},  {13, 34, 32}};
  const auto on_rim = [&](const Point3& p) {
    return std::find(mesh.points.begin(), mesh.points.begin() + kRim, p) != mesh.points.begin() + kRim;
  };
  const CellHoles work = WorkOf(mesh, false, [&](const Point3& a, const Point3& b) { return on_rim(a) && on_rim(b); });
  const HolePatch patch = FillHoles(work, With(Surface::kThinPlate)).at(0);
  ExpectClosesHole(work, work.holes[0], patch);
  for (const Triangle& t : patch.triangles) EXPECT_GT(AreaVector2(work, patch, t).z(), 0);
}

TEST_P(FillHolesTest, StaysOnATiltedPlane) {
  const auto plane = [](double x, double y) { return 0.5 * x - 0.25 * y + 3; };
  const CellHoles work = HoleOf(kSquareHole, plane);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  for (const Point3& p : patch.new_points) EXPECT_NEAR(p.z(), plane(p.x(), p.y()), work.lattice_step);
}

// x from z, y from x, z from y: a turn, so that what faced up faces +x.
Point3 Upend(const Point3& p) { return {p.z(), p.x(), p.y()}; }

TEST_P(FillHolesTest, FillsAHoleInAFacadeThatFacesPlusX) {
  const CellHoles work = MovedWork(HoleOf(kSquareHole), Upend);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_NEAR(PatchArea(work, patch), 36, 1e-9);
  for (const Triangle& t : patch.triangles) EXPECT_GT(AreaVector2(work, patch, t).x(), 0);
}

TEST_P(FillHolesTest, FillsAFacadeLikeTheGround) {
  const CellHoles ground = HoleOf(kHoleWithIsland, Waves), facade = MovedWork(ground, Upend);
  const HolePatch flat = Fill(ground), upright = Fill(facade);
  ExpectClosesHole(facade, facade.holes[0], upright);
  EXPECT_NEAR(PatchArea(facade, upright), PatchArea(ground, flat), 0.02 * PatchArea(ground, flat));
}

// The rim of the hole runs over a house.
TEST_P(FillHolesTest, FillsAHoleInTheGroundAsAnOpenOne) {
  CellHoles work = WorkOfSheet(Disc(1, kWallHeight / 3, 6), FoldToBuilding, kNoise);
  for (RimVertex& v : work.vertices) v.on_object = v.position.z() > 1;
  work.holes[0].in_ground = true;
  const HolePatch closed = Fill(work);
  ASSERT_THAT(closed.failure, IsEmpty());
  EXPECT_EQ(closed.way, FillWay::kFoldsCut);
  work.holes[0].in_ground = false;
  work.holes[0].open = true;
  const HolePatch open = Fill(work);
  EXPECT_EQ(closed.new_points, open.new_points);
  EXPECT_EQ(closed.triangles, open.triangles);
}

TEST_P(FillHolesTest, AFacadeThatReachesTheGroundIsNoHoleInIt) {
  CellHoles work = MovedWork(HoleOf(kHoleWithIsland, Waves), Upend);
  const HolePatch before = Fill(work);
  work.holes[0].in_ground = true;
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_EQ(patch.new_points, before.new_points);
  EXPECT_EQ(patch.triangles, before.triangles);
}

TEST_P(FillHolesTest, LeavesAnIslandInTheHole) {
  const CellHoles work = HoleOf(kHoleWithIsland);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_NEAR(PatchArea(work, patch), 8 * 6 - 3 * 2, 1e-9);
}

TEST_P(FillHolesTest, FillsAHoleThatTouchesItself) {
  const CellHoles work = HoleOf(kPinchedHole);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_NEAR(PatchArea(work, patch), 18, 1e-9);
}

TEST_P(FillHolesTest, FillsAHoleOfOneTriangle) {
  TriMesh mesh = DiscMesh(3, 8);
  mesh.triangles.erase(mesh.triangles.begin());
  const auto inner = [](const Point3& a, const Point3& b) { return a.norm() < 2 && b.norm() < 2; };
  const CellHoles work = WorkOf(mesh, false, inner);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_EQ(patch.triangles.size(), 1u);
}

// A box without its top corner: the three faces that meet there keep all but the squares at it, so that the hole's
// boundary turns about a corner of space.
TEST_P(FillHolesTest, FillsAHoleAroundTheCornerOfABox) {
  TriMesh box;
  const auto add_face = [&](const std::function<Point3(const Point3&)>& place) {
    const TriMesh face = SquaresMesh(0, 4, 0, 4, [](int32_t i, int32_t j) { return i >= 2 || j >= 2; });
    for (Triangle t : face.triangles) {
      for (int32_t& v : t) v += static_cast<int32_t>(box.points.size());
      box.triangles.push_back(t);
    }
    for (const Point3& p : face.points) box.points.push_back(place(p));
  };
  add_face([](const Point3& p) { return Point3(-p.x(), -p.y(), 0); });
  add_face([](const Point3& p) { return Point3(0, -p.x(), -p.y()); });
  add_face([](const Point3& p) { return Point3(-p.y(), 0, -p.x()); });
  const auto inner = [](const Point3& a, const Point3& b) { return a.minCoeff() > -4 && b.minCoeff() > -4; };
  const CellHoles work = WorkOf(box, false, inner);
  ASSERT_EQ(work.holes[0].segments.size(), 12u);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
}

// A slit that runs round three quarters of a cylinder: on the plane of its boundary it covers itself.
TEST_P(FillHolesTest, FillsAHoleThatProjectsOnNoPlane) {
  CellHoles work;
  work.lattice_step = 0x1p-10;
  CellHole hole;
  const int32_t steps = 18;
  for (int32_t i = 0; i <= 2 * steps + 1; ++i) {
    const bool back = i > steps;
    const double angle = 1.5 * std::numbers::pi * (back ? 2 * steps + 1 - i : i) / steps;
    RimVertex v;
    v.index = i;
    v.position = Point3(4 * std::cos(angle), 4 * std::sin(angle), back ? 1 : 0);
    v.size = 1;
    work.vertices.push_back(v);
    work.band.points.push_back(v.position);
    hole.segments.push_back({i, (i + 1) % (2 * steps + 2), false});
  }
  work.holes.push_back(hole);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_NEAR(PatchArea(work, patch), 1.5 * std::numbers::pi * 4, 0.2);
}

// An open hole outside its own boundary, which bounds nothing.
TEST_P(FillHolesTest, SaysWhyAHoleStaysOpen) {
  CellHoles work = HoleOf(kSquareHole);
  for (RimSegment& s : work.holes[0].segments) std::swap(s.from, s.to);
  work.holes[0].open = true;
  const HolePatch patch = Fill(work);
  EXPECT_THAT(patch.failure, HasSubstr("boundary"));
  EXPECT_THAT(patch.triangles, IsEmpty());
  EXPECT_THAT(patch.new_points, IsEmpty());
}

// A tube of four sides, open at one end: its mouth is a square, two corners of it higher than the others by `rise`.
CellHoles MouthOfATube(double rise) {
  CellHoles work;
  work.lattice_step = 0x1p-10;
  for (const Point3& p : {Point3(0, 0, 0), Point3(4, 0, rise), Point3(4, 4, 0), Point3(0, 4, rise)}) {
    RimVertex v;
    v.index = static_cast<int32_t>(work.vertices.size());
    v.position = p;
    v.size = 4;
    work.vertices.push_back(v);
    work.band.points.push_back(p);
  }
  work.holes.push_back({0, false, {{0, 1, false}, {1, 2, false}, {2, 3, false}, {3, 0, false}}});
  work.band.points.emplace_back(2, 2, -4);
  work.band.triangles = {{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  return work;
}

void ExpectNoDiagonal(const HolePatch& patch) {
  const auto has = [](const Triangle& t, int32_t v) { return std::find(t.begin(), t.end(), v) != t.end(); };
  for (const Triangle& t : patch.triangles) {
    EXPECT_FALSE(has(t, 0) && has(t, 2));
    EXPECT_FALSE(has(t, 1) && has(t, 3));
  }
}

TEST(FillLikeWangTest, MakesNoEdgeThatTheSurfaceHasAlready) {
  CellHoles work = MouthOfATube(0);
  const HolePatch before = FillHoles(work, With(Surface::kWang)).at(0);
  ExpectClosesHole(work, work.holes[0], before);
  ASSERT_EQ(before.triangles.size(), 2u) << "a square of edges of the wanted size takes one diagonal";
  work.band.points.emplace_back(2, 2, -8);  // with both diagonals
  work.band.triangles.push_back({0, 2, 5});
  work.band.triangles.push_back({1, 3, 5});
  const HolePatch patch = FillHoles(work, With(Surface::kWang)).at(0);
  ExpectClosesHole(work, work.holes[0], patch);
  ExpectNoDiagonal(patch);
}

// One diagonal passes above the other: a patch has room between the surface on one and the surface below the other.
TEST(FillWithAThinPlateTest, MakesNoEdgeThatTheSurfaceHasAlready) {
  CellHoles work = MouthOfATube(1);
  const HolePatch before = FillHoles(work, With(Surface::kThinPlate)).at(0);
  ExpectClosesHole(work, work.holes[0], before);
  ASSERT_EQ(before.triangles.size(), 2u);
  work.band.points.emplace_back(2, 2, -8);
  work.band.points.emplace_back(2, 2, 8);
  work.band.triangles.push_back({0, 2, 5});
  work.band.triangles.push_back({1, 3, 6});
  const HolePatch patch = FillHoles(work, With(Surface::kThinPlate)).at(0);
  ExpectClosesHole(work, work.holes[0], patch);
  ExpectNoDiagonal(patch);
}

// A wide hole: triangles grow inward by default.
TEST_P(FillHolesTest, KeepsTheRimsSizeThroughoutWhenUniform) {
  Picture wide(34, "##" + std::string(30, '.') + "##");
  wide[0] = wide[1] = wide[32] = wide[33] = std::string(34, '#');
  const CellHoles work = HoleOf(wide);
  FillOptions uniform = With(GetParam());
  uniform.refine.uniform = true;
  const HolePatch graded = Fill(work), even = FillHoles(work, uniform)[0];
  ExpectClosesHole(work, work.holes[0], even);
  EXPECT_GT(even.triangles.size(), 2 * graded.triangles.size());
  EXPECT_NEAR(PatchArea(work, even) / static_cast<double>(even.triangles.size()), std::sqrt(0.75) / 2, 0.15)
      << "of an equilateral triangle with the rim's edge length";
}

bool SamePatch(const HolePatch& a, const HolePatch& b) {
  return a.new_points == b.new_points && a.triangles == b.triangles && a.failure == b.failure;
}

TEST_P(FillHolesTest, GivesTheSameBitsEveryTime) {
  const CellHoles work = HoleOf(kHoleWithIsland, Waves);
  EXPECT_TRUE(SamePatch(Fill(work), Fill(work)));
}

TEST_P(FillHolesTest, FillsAHoleTheSameAloneAndBesideOthers) {
  CellHoles work = HoleOf(kPinchedHole, Waves);
  std::vector<CellHole> parts(2);
  for (const RimSegment& s : work.holes[0].segments) {
    const bool west = work.vertices[s.from].position.x() + work.vertices[s.to].position.x() < 8;
    parts[west ? 0 : 1].segments.push_back(s);
  }
  parts[1].id = 1;
  work.holes = parts;
  const std::vector<HolePatch> both = FillHoles(work, With(GetParam()));
  for (const int k : {0, 1}) {
    work.holes = {parts[k]};
    EXPECT_TRUE(SamePatch(both[k], Fill(work)));
    EXPECT_EQ(both[k].hole, k);
  }
}

class MovedHoleTest : public testing::TestWithParam<std::tuple<Picture, Surface>> {
 protected:
  const Picture& picture() const { return std::get<0>(GetParam()); }
  static HolePatch Fill(const CellHoles& work) { return FillHoles(work, With(std::get<1>(GetParam()))).at(0); }
};
INSTANTIATE_TEST_SUITE_P(Pictures, MovedHoleTest,
                         testing::Combine(testing::Values(kSquareHole, kHoleWithIsland, kPinchedHole),
                                          testing::Values(Surface::kWang, Surface::kThinPlate)));

TEST_P(MovedHoleTest, FillsAHoleTurnedByAQuarterAlike) {
  const CellHoles work = HoleOf(picture(), Waves);
  const CellHoles turned = MovedWork(work, [](const Point3& p) { return Point3(-p.y(), p.x(), p.z()); });
  const HolePatch a = Fill(work), b = Fill(turned);
  ExpectClosesHole(turned, turned.holes[0], b);
  EXPECT_NEAR(PatchArea(work, a), PatchArea(turned, b), 0.01 * PatchArea(work, a));
  EXPECT_NEAR(a.triangles.size(), b.triangles.size(), 0.1 * a.triangles.size() + 2);
}

TEST_P(MovedHoleTest, FillsAHoleFarFromTheOriginAlike) {
  const CellHoles work = HoleOf(picture(), Waves);
  const CellHoles far = MovedWork(work, [](const Point3& p) { return Point3(p.x() + 1e4, p.y() - 1e4, p.z()); });
  const HolePatch a = Fill(work), b = Fill(far);
  ExpectClosesHole(far, far.holes[0], b);
  EXPECT_NEAR(PatchArea(work, a), PatchArea(far, b), 0.01 * PatchArea(work, a));
  EXPECT_NEAR(a.triangles.size(), b.triangles.size(), 0.1 * a.triangles.size() + 2);
}

TEST_P(MovedHoleTest, LiftsThePatchWithItsRim) {
  const CellHoles work = HoleOf(picture(), Waves);
  const CellHoles lifted = MovedWork(work, [](const Point3& p) { return Point3(p.x(), p.y(), p.z() + 512); });
  const HolePatch a = Fill(work), b = Fill(lifted);
  ASSERT_EQ(a.triangles, b.triangles);
  for (size_t i = 0; i < a.new_points.size(); ++i) {
    EXPECT_NEAR(a.new_points[i].z() + 512, b.new_points[i].z(), 1.5 * work.lattice_step);
  }
}

}  // namespace
}  // namespace tilemend
