// The promises of docs/architecture.md on made scenes, for both surfaces: the waves in memory, without services.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "tests/support/fill_pipeline.h"
#include "tests/support/scene_maker.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;

constexpr double kCell = 50;
constexpr int32_t kCells = 3;

struct SceneKind {
  const char* name;
  bool lakes, islands, river;
  double small_per_cell;
};

void PrintTo(const SceneKind& kind, std::ostream* out) { *out << kind.name; }

constexpr SceneKind kSmall{"Small", false, false, false, 4};
constexpr SceneKind kLakes{"Lakes", true, false, false, 0};
constexpr SceneKind kIslands{"Islands", true, true, false, 0};
constexpr SceneKind kRiver{"River", false, false, true, 0};
constexpr SceneKind kAll{"All", true, true, true, 2};

class PipelineTest : public testing::TestWithParam<std::tuple<Surface, Cut, SceneKind, uint64_t>> {
 public:
  static std::string NameOf(const ParamType& param) {
    const auto& [surface, cut, kind, seed] = param;
    return std::string(surface == Surface::kWang ? "Wang" : "ThinPlate") + tilemend::NameOf(cut) + kind.name +
           std::to_string(seed);
  }

 protected:
  static void SetUpTestSuite() { cache_ = new std::map<std::string, Made>; }
  static void TearDownTestSuite() {
    delete cache_;
    cache_ = nullptr;
  }

  struct Made {
    SurveyedScene scene;
    FilledScene filled;
    TriMesh welded;
  };

  // The scene of this test's parameters, filled once for all tests.
  const Made& Scene() const {
    const auto& [surface, cut, kind, seed] = GetParam();
    Made& made = (*cache_)[NameOf(GetParam())];
    if (!made.scene.tiles.empty()) return made;
    SceneMakerOptions options;
    options.cols = options.rows = kCells;
    options.cell_size = kCell;
    options.cut = cut;
    options.seed = seed;
    options.lakes = kind.lakes;
    options.islands = kind.islands;
    options.river = kind.river;
    options.small_per_cell = kind.small_per_cell;
    made.scene = SurveyScene(MakeScene(options));
    PipelineOptions pipeline;
    pipeline.fill.surface = surface;
    made.filled = FillScene(made.scene, pipeline);
    made.welded = WeldTiles(made.filled.tiles);
    return made;
  }

 private:
  static std::map<std::string, Made>* cache_;
};

std::map<std::string, PipelineTest::Made>* PipelineTest::cache_ = nullptr;

INSTANTIATE_TEST_SUITE_P(Scenes, PipelineTest,
                         testing::Combine(testing::Values(Surface::kThinPlate, Surface::kWang),
                                          testing::Values(Cut::kClipped, Cut::kRagged),
                                          testing::Values(kSmall, kLakes, kIslands, kRiver, kAll),
                                          testing::Values(1, 2, 5)),
                         [](const auto& test) { return PipelineTest::NameOf(test.param); });

using EdgeUses = std::map<std::pair<int32_t, int32_t>, std::vector<bool>>;  // forward or not, for each triangle

EdgeUses UsesOf(const TriMesh& mesh) {
  EdgeUses uses;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      uses[{std::min(a, b), std::max(a, b)}].push_back(a < b);
    }
  }
  return uses;
}

double Area2(const TriMesh& mesh, const Triangle& t) {
  const Point2 a = mesh.points[t[0]].head<2>();
  const Point2 u = mesh.points[t[1]].head<2>() - a, v = mesh.points[t[2]].head<2>() - a;
  return u.x() * v.y() - u.y() * v.x();
}

bool OnRimOfArea(const Point3& a, const Point3& b, double size = kCells * kCell) {
  for (const int axis : {0, 1}) {
    for (const double line : {0.0, size}) {
      if (a[axis] == line && b[axis] == line) return true;
    }
  }
  return false;
}

TEST_P(PipelineTest, FillsEveryHoleThatItFinds) {
  const Made& made = Scene();
  EXPECT_THAT(made.filled.plan.left, IsEmpty());
  EXPECT_FALSE(made.filled.plan.holes.empty());
  EXPECT_EQ(made.filled.patches.size(), made.filled.plan.holes.size());
  for (const auto& [hole, patch] : made.filled.patches) {
    EXPECT_EQ(patch.failure, "") << "hole " << hole;
    EXPECT_FALSE(patch.triangles.empty()) << "hole " << hole;
  }
}

TEST_P(PipelineTest, KeepsTheOriginals) {
  const Made& made = Scene();
  for (const auto& [cell, tile] : made.scene.tiles) {
    if (tile.triangles.empty()) continue;
    const TriMesh& after = made.filled.tiles.at(cell);
    ASSERT_GE(after.points.size(), tile.points.size());
    ASSERT_GE(after.triangles.size(), tile.triangles.size());
    EXPECT_TRUE(std::equal(tile.points.begin(), tile.points.end(), after.points.begin()));
    EXPECT_TRUE(std::equal(tile.triangles.begin(), tile.triangles.end(), after.triangles.begin()));
  }
}

TEST_P(PipelineTest, LeavesNoBoundaryOffTheRimOfTheArea) {
  const Made& made = Scene();
  for (const auto& [edge, uses] : UsesOf(made.welded)) {
    if (uses.size() != 1) continue;
    const Point3 a = made.welded.points[edge.first], b = made.welded.points[edge.second];
    EXPECT_TRUE(OnRimOfArea(a, b)) << a.transpose() << " to " << b.transpose();
  }
}

TEST_P(PipelineTest, JoinsTwoTrianglesOfOneOrientationAtEveryInnerEdge) {
  const Made& made = Scene();
  for (const auto& [edge, uses] : UsesOf(made.welded)) {
    if (uses.size() < 2) continue;
    const Point3 a = made.welded.points[edge.first];
    ASSERT_EQ(uses.size(), 2u) << "at " << a.transpose();
    ASSERT_NE(uses[0], uses[1]) << "at " << a.transpose();
  }
}

TEST_P(PipelineTest, HasNoTriangleThatFacesDown) {
  const Made& made = Scene();
  for (const Triangle& t : made.welded.triangles) {
    ASSERT_GT(Area2(made.welded, t), 0) << "at " << made.welded.points[t[0]].transpose();
  }
}

TEST_P(PipelineTest, CoversTheAreaOfTheCells) {
  const Made& made = Scene();
  double area = 0;
  for (const Triangle& t : made.welded.triangles) area += Area2(made.welded, t) / 2;
  EXPECT_NEAR(area, kCells * kCells * kCell * kCell, 1e-6);
}

TEST_P(PipelineTest, SettlesEverySeamVertexOnTheLattice) {
  const Made& made = Scene();
  const Plan& plan = made.filled.plan;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      if (plan.vertices[s.from].index >= 0) continue;
      const auto height = made.filled.heights.height.find(s.from);
      ASSERT_NE(height, made.filled.heights.height.end());
      ASSERT_EQ(std::fmod(height->second, plan.lattice_step), 0);
    }
  }
}

TEST_P(PipelineTest, HoldsItsVerticesInTheNumbersOfTheTiles) {
  const Made& made = Scene();
  for (const Point3& p : made.welded.points) {
    ASSERT_EQ(p, RoundedTo(NumberType::kFloat32, p)) << "a float32 tile would move it";
  }
}

TEST_P(PipelineTest, StaysWithinReachOfTheHeightsAround) {
  const Made& made = Scene();
  double lo = 1e9, hi = -1e9;
  for (const auto& [cell, record] : made.scene.records) {
    lo = std::min(lo, record.lo.z());
    hi = std::max(hi, record.hi.z());
  }
  const double slack = 0.5 * (hi - lo);
  for (const Point3& p : made.welded.points) {
    ASSERT_GT(p.z(), lo - slack) << p.transpose();
    ASSERT_LT(p.z(), hi + slack) << p.transpose();
  }
}

// A scene at one height is filled at that height, whatever the cut, the layers and the seams.
TEST(FlatSceneTest, IsFilledFlat) {
  for (const Cut cut : {Cut::kClipped, Cut::kRagged}) {
    SceneMakerOptions options;
    options.cols = options.rows = 4;
    options.cut = cut;
    options.relief = 0;
    options.ellipses = {{{95, 105}, {70, 60}}};
    const FilledScene filled = FillScene(SurveyScene(MakeScene(options)));
    ASSERT_GE(filled.plan.layers, 2);
    for (const auto& [cell, tile] : filled.tiles) {
      for (const Point3& p : tile.points) ASSERT_EQ(p.z(), 0) << p.transpose();
    }
  }
}

TEST(EmptyCellTest, IsFilledFromItsNeighbours) {
  for (const Cut cut : {Cut::kClipped, Cut::kRagged}) {
    SceneMakerOptions options;
    options.cols = options.rows = 3;
    options.cut = cut;
    options.empty = {{1, 1}};
    const SurveyedScene scene = SurveyScene(MakeScene(options));
    const FilledScene filled = FillScene(scene);
    EXPECT_EQ(filled.patches.size(), filled.plan.holes.size());
    double area = 0;
    const TriMesh welded = WeldTiles(filled.tiles);
    for (const Triangle& t : welded.triangles) area += Area2(welded, t) / 2;
    EXPECT_NEAR(area, 150 * 150, 1e-6);
    EXPECT_FALSE(filled.tiles.at({1, 1}).triangles.empty());
  }
}

// Seams agree to the bit only because both sides take one height: without the seam's smoothing it must hold as well.
TEST(SeamTest, ClosesWithAnySmoothing) {
  SceneMakerOptions options;
  options.cols = options.rows = 2;
  options.ellipses = {{{50, 50}, {30, 25}}};
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  for (const double gamma : {0.0, 0.9}) {
    PipelineOptions pipeline;
    pipeline.fill.surface = Surface::kWang;
    pipeline.fill.wang.seam_smoothing = gamma;
    const TriMesh welded = WeldTiles(FillScene(scene, pipeline).tiles);
    for (const auto& [edge, uses] : UsesOf(welded)) {
      const Point3 a = welded.points[edge.first], b = welded.points[edge.second];
      const bool rim =
          (a.x() == b.x() && (a.x() == 0 || a.x() == 100)) || (a.y() == b.y() && (a.y() == 0 || a.y() == 100));
      ASSERT_EQ(uses.size(), rim ? 1u : 2u) << "gamma " << gamma << " at " << a.transpose();
    }
  }
}

// A lake of three layers on hills.
SurveyedScene DeepLake(Cut cut) {
  SceneMakerOptions options;
  options.cols = options.rows = 5;
  options.cut = cut;
  options.ellipses = {{{125, 125}, {115, 115}}};
  return SurveyScene(MakeScene(options));
}

using Change = std::function<void(WangOptions&)>;

class WangStepTest : public testing::TestWithParam<Cut> {
 protected:
  std::map<CellId, TriMesh> Fill(const Change& change) const {
    PipelineOptions options;
    options.fill.surface = Surface::kWang;
    change(options.fill.wang);
    const FilledScene filled = FillScene(DeepLake(GetParam()), options);
    EXPECT_EQ(filled.plan.layers, 3);
    for (const auto& [hole, patch] : filled.patches) EXPECT_EQ(patch.failure, "");
    return filled.tiles;
  }
};
INSTANTIATE_TEST_SUITE_P(Cuts, WangStepTest, testing::Values(Cut::kClipped, Cut::kRagged));

// Each step of the paper leaves its mark on the result.
TEST_P(WangStepTest, EveryStepIsSeen) {
  const auto whole = Fill([](WangOptions&) {});
  const Change changes[] = {
      [](WangOptions& w) { w.adjust = false; },          [](WangOptions& w) { w.fairing_steps = 0; },
      [](WangOptions& w) { w.seam_smoothing = 0; },      [](WangOptions& w) { w.seam_buffer = 1; },
      [](WangOptions& w) { w.longest_loop = 20; },       [](WangOptions& w) { w.seam_points = SeamPoints::kSpaced; },
      [](WangOptions& w) { w.closure = Closure::kLine; }};
  for (const Change& change : changes) {
    const auto other = Fill(change);
    const bool same = std::equal(whole.begin(), whole.end(), other.begin(),
                                 [](const auto& a, const auto& b) { return a.second.points == b.second.points; });
    EXPECT_FALSE(same) << "change " << &change - changes;
  }
}

TEST(DeterminismTest, GivesTheSameTilesEveryTime) {
  SceneMakerOptions options;
  options.lakes = options.river = true;
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  const FilledScene a = FillScene(scene), b = FillScene(scene);
  for (const auto& [cell, tile] : a.tiles) {
    EXPECT_EQ(tile.points, b.tiles.at(cell).points);
    EXPECT_EQ(tile.triangles, b.tiles.at(cell).triangles);
  }
}

class WaterPipelineTest : public testing::TestWithParam<std::tuple<Cut, Surface>> {};

// One height for every new vertex over nine cells, on the seams and off them, on a surface that is closed.
TEST_P(WaterPipelineTest, ALakeIsFlatOverAllItsCells) {
  const auto [cut, surface] = GetParam();
  PipelineOptions options;
  options.fill.surface = surface;
  const FilledScene filled = FillScene(SurveyScene(MakeScene(LakeOverNineCells(cut))), options);
  ASSERT_EQ(filled.plan.water.size(), 1U);
  const double level = filled.plan.water[0].level;
  EXPECT_NEAR(level, kWaterLevel, 0.03);
  EXPECT_EQ(filled.patches.size(), 9U);
  size_t new_points = 0;
  for (const auto& [hole, patch] : filled.patches) {
    EXPECT_EQ(patch.failure, "");
    for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), level);
    new_points += patch.new_points.size();
  }
  EXPECT_GT(new_points, 50U);
  for (const auto& [vertex, height] : filled.heights.height) EXPECT_EQ(height, level);
  const TriMesh welded = WeldTiles(filled.tiles);
  for (const auto& [edge, uses] : UsesOf(welded)) {
    if (uses.size() == 2) continue;
    EXPECT_EQ(uses.size(), 1U);
    EXPECT_TRUE(OnRimOfArea(welded.points[edge.first], welded.points[edge.second], 120));
  }
}

INSTANTIATE_TEST_SUITE_P(Lakes, WaterPipelineTest,
                         testing::Combine(testing::Values(Cut::kClipped, Cut::kRagged),
                                          testing::Values(Surface::kWang, Surface::kThinPlate)),
                         [](const auto& test) {
                           return NameOf(std::get<0>(test.param)) +
                                  (std::get<1>(test.param) == Surface::kWang ? "Wang" : "ThinPlate");
                         });

// The new triangles of all tiles, as corners.
std::vector<std::array<Point3, 3>> FilledTriangles(const SurveyedScene& scene, const FilledScene& filled) {
  std::vector<std::array<Point3, 3>> triangles;
  for (const auto& [cell, tile] : filled.tiles) {
    const auto record = scene.records.find(cell);
    const auto own = record == scene.records.end() ? 0 : static_cast<size_t>(record->second.triangle_count);
    for (size_t t = own; t < tile.triangles.size(); ++t) {
      const Triangle& c = tile.triangles[t];
      triangles.push_back({tile.points[c[0]], tile.points[c[1]], tile.points[c[2]]});
    }
  }
  return triangles;
}

std::optional<double> HeightOver(const std::vector<std::array<Point3, 3>>& triangles, const Point2& p) {
  const auto area = [](const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); };
  for (const auto& [a, b, c] : triangles) {
    const Point2 u = b.head<2>() - a.head<2>(), v = c.head<2>() - a.head<2>(), w = p - a.head<2>();
    const double s = area(w, v) / area(u, v), t = area(u, w) / area(u, v);
    if (s >= 0 && t >= 0 && s + t <= 1) return a.z() + s * (b.z() - a.z()) + t * (c.z() - a.z());
  }
  return std::nullopt;
}

std::vector<std::array<Point3, 3>> Filled(const SceneMakerOptions& options) {
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  return FilledTriangles(scene, FillScene(scene));
}

// The mean |difference| of a fill from a height, at places over all nine cells.
double MeanApart(const std::vector<std::array<Point3, 3>>& fill,
                 const std::function<std::optional<double>(Point2)>& height) {
  double apart = 0;
  int places = 0;
  for (double x = 21; x < 100; x += 4) {
    for (double y = 21; y < 100; y += 4) {
      const auto a = HeightOver(fill, {x, y}), b = height({x, y});
      if (!a || !b) continue;
      apart += std::abs(*a - *b);
      ++places;
    }
  }
  EXPECT_GT(places, 100);
  return apart / places;
}

TEST(AmongHousesTest, TheSurfaceDoesNotDependOnWhereTheGridCuts) {
  SceneMakerOptions options = HoleOverNineCells(Cut::kRagged, [](double, double x, double y) {
    return 0.05 * x + 2 * std::sin(y / 15) + (std::fmod(y, 24) < 10 ? 9 : 0);
  });
  const auto cut = Filled(options);
  options.cols = options.rows = 1;
  options.cell_size *= 3;
  const auto whole = Filled(options);
  // Of the rim, houses too: the walls up to them stand in the first row of triangles, which differs with the grid.
  const double relief = 0.05 * 100 + 2 * 2 + 9;
  EXPECT_LT(MeanApart(cut, [&](const Point2& p) { return HeightOver(whole, p); }), 0.01 * relief);
}

// Hills on a plane of 45 degrees, along its normal.
double Hillside(double x, double y) {
  const auto over_plane = [&](double u) { return 10 * std::sin(u / 45) * std::cos(y / 45); };
  double u = std::sqrt(2.0) * x;
  for (int k = 0; k < 60; ++k) u = std::sqrt(2.0) * x + over_plane(u);
  return (u + over_plane(u)) / std::sqrt(2.0);
}

TEST(SteepGroundTest, IsFilledAlongTheSlope) {
  const auto fill = Filled(HoleOverNineCells(Cut::kRagged, [](double, double x, double y) { return Hillside(x, y); }));
  const double apart = MeanApart(fill, [](const Point2& p) { return Hillside(p.x(), p.y()); });
  EXPECT_LT(apart, 0.2);  // over the ground 0.28
}

}  // namespace
}  // namespace tilemend
