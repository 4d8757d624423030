// What every plan promises, on made scenes of both cuts; and what a plan must not depend on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "coordinator/plan/plan.h"
#include "tests/support/plan_checks.h"
#include "tests/support/scene_maker.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using Xyz = std::array<double, 3>;

SceneMakerOptions Options(Cut cut, uint64_t seed) {
  SceneMakerOptions options;
  options.cols = options.rows = 3;
  options.cut = cut;
  options.seed = seed;
  return options;
}

SceneMakerOptions EveryKindOfHole(Cut cut, uint64_t seed) {
  SceneMakerOptions options = Options(cut, seed);
  options.lakes = options.islands = options.river = true;
  options.small_per_cell = 2;
  return options;
}

Plan PlanOf(const SceneMakerOptions& options) { return PlanOf(SurveyScene(MakeScene(options))); }

double OpenArea(const Plan& plan) {
  double area = 0;
  for (const PlannedHole& hole : plan.holes) area += hole.area;
  return area;
}

double SurfaceArea(const SurveyedScene& scene) {
  double area = 0;
  for (const auto& [cell, tile] : scene.tiles) {
    for (const Triangle& t : tile.triangles) {
      const Point2 a = tile.points[t[0]].head<2>();
      const Point2 u = tile.points[t[1]].head<2>() - a, v = tile.points[t[2]].head<2>() - a;
      area += (u.x() * v.y() - u.y() * v.x()) / 2;
    }
  }
  return area;
}

class MadeSceneTest : public testing::TestWithParam<std::tuple<Cut, uint64_t>> {
 protected:
  Cut cut() const { return std::get<0>(GetParam()); }
  uint64_t seed() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Cuts, MadeSceneTest,
                         testing::Combine(testing::Values(Cut::kClipped, Cut::kRagged), testing::Values(1, 2, 4)),
                         [](const auto& test) {
                           return NameOf(std::get<0>(test.param)) + std::to_string(std::get<1>(test.param));
                         });

TEST_P(MadeSceneTest, BoundsEveryHoleByClosedWalks) {
  const Plan plan = PlanOf(EveryKindOfHole(cut(), seed()));
  ASSERT_FALSE(plan.holes.empty());
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    std::map<int32_t, int> balance;
    for (const RimSegment& s : plan.holes[h].segments) {
      ++balance[s.from];
      --balance[s.to];
    }
    for (const auto& [vertex, n] : balance) ASSERT_EQ(n, 0) << "hole " << h << " vertex " << vertex;
  }
}

TEST_P(MadeSceneTest, GivesEverySeamSegmentToBothCellsInOppositeDirections) {
  const SurveyedScene scene = SurveyScene(MakeScene(EveryKindOfHole(cut(), seed())));
  const Plan plan = PlanOf(scene);
  std::map<std::pair<int32_t, int32_t>, std::vector<CellId>> users;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      if (s.seam) users[{s.from, s.to}].push_back(hole.cell);
    }
  }
  size_t segments = 0;
  for (const Seam& seam : plan.seams) {
    for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
      const int32_t p = seam.vertices[i], q = seam.vertices[i + 1];
      if (!users.contains({p, q}) && !users.contains({q, p})) continue;  // along an edge of the surface
      const bool vertical = seam.a.row == seam.b.row;
      const CellId left = vertical ? seam.a : seam.b, right = vertical ? seam.b : seam.a;
      if (scene.tiles.contains(left)) {
        ++segments;
        ASSERT_EQ((users[{p, q}]), std::vector<CellId>{left});
      }
      if (scene.tiles.contains(right)) {
        ++segments;
        ASSERT_EQ((users[{q, p}]), std::vector<CellId>{right});
      }
    }
  }
  const size_t used = std::accumulate(users.begin(), users.end(), size_t{0},
                                      [](size_t n, const auto& u) { return n + u.second.size(); });
  EXPECT_GT(segments, 0u);
  EXPECT_EQ(segments, used) << "seam segments of holes that belong to no seam";
}

TEST_P(MadeSceneTest, GivesEveryBoundaryEdgeToOneHoleAlone) {
  const Plan plan = PlanOf(EveryKindOfHole(cut(), seed()));
  std::set<std::pair<int32_t, int32_t>> used;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      EXPECT_TRUE(used.emplace(s.from, s.to).second) << s.from << " -> " << s.to;
    }
  }
}

TEST_P(MadeSceneTest, CoversWithItsHolesWhatTheSurfaceLeavesOfTheArea) {
  const SurveyedScene scene = SurveyScene(MakeScene(EveryKindOfHole(cut(), seed())));
  const Plan plan = PlanOf(scene);
  EXPECT_THAT(plan.left, IsEmpty());
  EXPECT_NEAR(OpenArea(plan) + SurfaceArea(scene), 150 * 150, 1e-3);
}

TEST_P(MadeSceneTest, LaysSeamVerticesOnTheLatticeAndOnTheGridLines) {
  const Plan plan = PlanOf(EveryKindOfHole(cut(), seed()));
  int seam_vertices = 0;
  for (const PlanVertex& v : plan.vertices) {
    if (v.index >= 0) continue;
    ++seam_vertices;
    for (const int axis : {0, 1}) {
      EXPECT_EQ(std::fmod(v.position[axis], plan.lattice_step), 0);
      const double line = std::round(v.position[axis] / 50) * 50;
      EXPECT_TRUE((v.lines & (1 << axis)) == 0 || v.position[axis] == line) << v.position.transpose();
    }
    EXPECT_NE(v.lines, 0);
  }
  EXPECT_GT(seam_vertices, 0);
}

// An ellipse that lies well inside one cell, one over a border, one over a corner, one over the rim, a strait and an
// empty cell: shapes whose counts do not hang on the triangles at their rims.
TEST_P(MadeSceneTest, CountsRaggedHolesLikeClippedOnes) {
  SceneMakerOptions options = Options(cut(), seed());
  options.ellipses = {{{25, 25}, {9, 12}}, {{50, 75}, {10, 14}}, {{100, 50}, {18, 16}}, {{150, 120}, {10, 15}}};
  options.boxes = {{{65, 90}, {85, 160}}};
  EXPECT_EQ(CountsOf(PlanOf(options)), "1 closed, 7 IB, 1 IIB, 1 IIC");
}

// Stairs on two sides, and a cell in the middle that is not in the area.
const std::vector<CellId> kStairs = {{0, 0}, {1, 0}, {0, 1}, {3, 3}, {3, 2}, {1, 2}};

TEST_P(MadeSceneTest, TakesTheOutlineOfStairsForNoHole) {
  for (const uint64_t s : {seed(), seed() + 10, seed() + 20}) {
    SceneMakerOptions options = Options(cut(), s);
    options.cols = options.rows = 4;
    options.out_of_area = kStairs;
    const Plan plan = PlanOf(options);
    EXPECT_EQ(CountsOf(plan), "none") << s;
    EXPECT_THAT(plan.seams, IsEmpty());
    ExpectSound(plan);
  }
}

// One hole over a border, one around a corner of the cell in the middle, one around a corner of the stairs, one closed.
TEST_P(MadeSceneTest, FindsTheHolesThatReachAnOutlineOfStairs) {
  for (const uint64_t s : {seed(), seed() + 10, seed() + 20}) {
    SceneMakerOptions options = Options(cut(), s);
    options.cols = options.rows = 4;
    options.out_of_area = kStairs;
    options.ellipses = {{{125, 50}, {12, 12}}, {{50, 150}, {20, 14}}, {{150, 100}, {14, 13}}, {{25, 175}, {7, 7}}};
    const Plan plan = PlanOf(options);
    EXPECT_EQ(CountsOf(plan), "1 closed, 4 IB, 4 IIB") << s;
    ExpectSound(plan);
  }
}

TEST_P(MadeSceneTest, CallsBordersBetweenWholeTilesExact) {
  const Plan plan = PlanOf(Options(cut(), seed()));
  ASSERT_THAT(plan.borders, SizeIs(12));
  for (const BorderAudit& border : plan.borders) {
    EXPECT_EQ(border.kind, BorderKind::kExact);
    EXPECT_GE(border.shared_vertices, 20);
  }
}

// The holes by what they are, not by numbers: cell, kind, type, layer, and the boundary by position.
using HoleFigures = std::tuple<CellId, HoleKind, HoleType, int32_t, std::multiset<std::pair<Xyz, Xyz>>>;

std::multiset<HoleFigures> FiguresOf(const Plan& plan, CellId shift, const Point3& move) {
  const auto key = [&](int32_t v) {
    const Point3 p = plan.vertices[v].position + move;
    return Xyz{p.x(), p.y(), plan.vertices[v].index < 0 ? 0 : p.z()};
  };
  std::multiset<HoleFigures> figures;
  for (const PlannedHole& hole : plan.holes) {
    std::multiset<std::pair<Xyz, Xyz>> boundary;
    for (const RimSegment& s : hole.segments) boundary.emplace(key(s.from), key(s.to));
    const CellId cell{hole.cell.col + shift.col, hole.cell.row + shift.row};
    figures.emplace(cell, hole.kind, hole.type, hole.layer, std::move(boundary));
  }
  return figures;
}

// The same tile with its vertices and triangles in another order.
TriMesh Shuffled(const TriMesh& mesh, std::mt19937& random) {
  std::vector<int32_t> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  TriMesh out;
  out.points.resize(mesh.points.size());
  for (size_t v = 0; v < place.size(); ++v) out.points[place[v]] = mesh.points[v];
  for (const Triangle& t : mesh.triangles) out.triangles.push_back({place[t[1]], place[t[2]], place[t[0]]});
  std::shuffle(out.triangles.begin(), out.triangles.end(), random);
  return out;
}

TEST_P(MadeSceneTest, DoesNotDependOnTheOrderOfVerticesAndTriangles) {
  const SurveyedScene scene = SurveyScene(MakeScene(EveryKindOfHole(cut(), seed())));
  std::mt19937 random(3);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) tiles[cell] = Shuffled(tile, random);
  const Plan shuffled = PlanOf(SurveyScene(scene.grid, tiles));
  EXPECT_EQ(FiguresOf(shuffled, {}, {0, 0, 0}), FiguresOf(PlanOf(scene), {}, {0, 0, 0}));
}

TEST_P(MadeSceneTest, MovesAlongWithASceneMovedByWholeCells) {
  MadeScene made = MakeScene(EveryKindOfHole(cut(), seed()));
  for (MadeTile& tile : made.tiles) {  // to a grid that stays exact where it is moved to
    for (Point3& p : tile.mesh.points) p = RoundedToLattice(p, 0x1p-10);
  }
  const SurveyedScene scene = SurveyScene(made);
  const CellId shift{3, -2};
  const Point3 move(3 * 50, -2 * 50, 0);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) {
    tiles[{cell.col + shift.col, cell.row + shift.row}] =
        Moved(tile, [&](const Point3& p) { return Point3(p + move); });
  }
  const Plan moved = PlanOf(SurveyScene(scene.grid, tiles));
  EXPECT_EQ(FiguresOf(moved, {}, {0, 0, 0}), FiguresOf(PlanOf(scene), shift, move));
}

// In an area whose edge leads through lakes: vertices there have no height before the fill.
TEST_P(MadeSceneTest, DoesNotDependOnTheHeightAboveSeaLevel) {
  MadeScene made = MakeScene(EveryKindOfHole(cut(), seed()));
  for (MadeTile& tile : made.tiles) {
    for (Point3& p : tile.mesh.points) p = RoundedToLattice(p, 0x1p-10);
  }
  const SurveyedScene scene = SurveyScene(made);
  const Point3 lift(0, 0, 1024);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles)
    tiles[cell] = Moved(tile, [&](const Point3& p) { return Point3(p + lift); });
  const SurveyedScene lifted = SurveyScene(scene.grid, tiles);
  const auto in_area = [](const SurveyedScene& of) {
    PlanInput input = of.Input();
    input.area.rings = {{{7, 9}, {140, 9}, {140, 141}, {7, 141}}};
    return MakePlan(input, {});
  };
  EXPECT_EQ(FiguresOf(in_area(lifted), {}, {0, 0, 0}), FiguresOf(in_area(scene), {}, lift));
}

// The outline of a lake ends beside the corner of four pieces: two holes were taken for one there.
TEST(PiecesTest, HolesAreCountedAsWithoutPieces) {
  SceneMakerOptions options;
  options.cell_size = 250;
  options.seed = 3089;
  options.cut = Cut::kOverlap;
  options.relief = 20;
  options.noise = 0.05;
  options.lakes = options.islands = options.river = true;
  options.small_per_cell = 3;
  const size_t whole = PlanOf(options).holes.size();
  options.pieces = 3;
  EXPECT_EQ(PlanOf(options).holes.size(), whole);
}

// So steep that normals say little of what is up.
TEST(SteepGroundTest, HolesAreToldFromIslandsSeenFromAbove) {
  const auto kept = [](int32_t x, int32_t y) {
    const bool in_hole = x >= 3 && x < 9 && y >= 3 && y < 9, in_island = x >= 5 && x < 7 && y >= 5 && y < 7;
    return !in_hole || in_island;
  };
  Grid grid;
  grid.cell_size = Point2(12, 12);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(-20, 20);
    TriMesh mesh = SquaresMesh(0, 12, 0, 12, kept);
    for (Point3& p : mesh.points) p.z() = height(random);
    const Plan plan = PlanOf(SurveyScene(grid, {{{0, 0}, mesh}}));
    ASSERT_THAT(plan.holes, SizeIs(1));
    EXPECT_EQ(plan.holes[0].kind, HoleKind::kClosed);
    EXPECT_NEAR(plan.holes[0].area, 36 - 4, 1e-9);
    EXPECT_EQ(plan.holes[0].segments.size(), 24U + 8U);
    EXPECT_EQ(plan.outer_rims, 0);
  }
}

}  // namespace
}  // namespace tilemend
