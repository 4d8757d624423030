// Water that is there as noisy surface, from the command line: it is taken out inside polygons and filled level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/mesh/plane_polygon.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr int kCell = 60;  // metres; two cells side by side, surface on a grid of one metre
constexpr double kLevel = 2, kGround = 6, kDeck = 4.5;
constexpr double kHalfLength = 38, kHalfWidth = 20;  // of the pond, an ellipse about the middle of the grid line
const Point2 kMiddle(kCell, 30);

// The same for the same place, between -1 and 1.
double NoiseAt(int x, int y) {
  uint32_t h = static_cast<uint32_t>(x) * 2654435761U ^ static_cast<uint32_t>(y) * 2246822519U;
  h = (h ^ (h >> 15)) * 2246822519U;
  return static_cast<double>(h % 2001) / 1000 - 1;
}

double RadiusAt(double x, double y) {
  return std::hypot((x - kMiddle.x()) / kHalfLength, (y - kMiddle.y()) / kHalfWidth);
}

// Noisy water in the ellipse, a bank of two metres around it, level ground.
double HeightAt(int x, int y) {
  const double beyond = (RadiusAt(x, y) - 1) * kHalfWidth;
  if (beyond <= 0) return kLevel + 0.3 * NoiseAt(x, y);
  return kLevel + std::min(beyond / 2, 1.0) * (kGround - kLevel);
}

class Tile {
 public:
  // Surface over [x0, x0 + kCell] x [0, kCell].
  explicit Tile(int x0) {
    for (int y = 0; y <= kCell; ++y) {
      for (int x = x0; x <= x0 + kCell; ++x) points_.emplace_back(x, y, HeightAt(x, y));
    }
    AddGrid(0, kCell, kCell);
  }
  // A level sheet of quads of one metre.
  void AddDeck(int x0, int y0, int width, int length) {
    const auto first = static_cast<int32_t>(points_.size());
    for (int y = y0; y <= y0 + length; ++y) {
      for (int x = x0; x <= x0 + width; ++x) points_.emplace_back(x, y, kDeck);
    }
    AddGrid(first, width, length);
  }

  std::string AsObj() const {
    std::string obj;
    for (const Point3& p : points_) absl::StrAppend(&obj, "v ", p.x(), " ", p.y(), " ", p.z(), "\n");
    for (const Triangle& t : triangles_) absl::StrAppend(&obj, "f ", t[0] + 1, " ", t[1] + 1, " ", t[2] + 1, "\n");
    return obj;
  }

 private:
  void AddGrid(int32_t first, int width, int length) {
    for (int32_t y = 0; y < length; ++y) {
      for (int32_t x = 0; x < width; ++x) {
        const int32_t a = first + y * (width + 1) + x, b = a + 1, c = b + width + 1, d = a + width + 1;
        triangles_.push_back({a, b, c});
        triangles_.push_back({a, c, d});
      }
    }
  }

  std::vector<Point3> points_;
  std::vector<Triangle> triangles_;
};

PlanePolygon PondOutline() {
  PlanePolygon polygon;
  polygon.rings.emplace_back();
  for (int k = 0; k < 72; ++k) {
    const double angle = 2 * M_PI * k / 72;
    polygon.rings[0].emplace_back(kMiddle.x() + kHalfLength * std::cos(angle),
                                  kMiddle.y() + kHalfWidth * std::sin(angle));
  }
  return polygon;
}

std::string FeatureOf(const PlanePolygon& polygon, const std::string& properties) {
  Json ring = Json::array();
  for (const Point2& p : polygon.rings[0]) ring.push_back({p.x(), p.y()});
  ring.push_back(ring[0]);
  return absl::StrCat(R"({"type": "Feature", "properties": )", properties,
                      R"(, "geometry": {"type": "Polygon", "coordinates": )", Json::array({ring}).dump(), "}}");
}

// The highest surface over p; NaN where there is none.
double TopAt(const TriMesh& mesh, const Point2& p) {
  double top = std::nan("");
  for (const Triangle& t : mesh.triangles) {
    const Point3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Point2 u = (b - a).head<2>(), v = (c - a).head<2>(), w = p - a.head<2>();
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0) continue;
    const double s = (w.x() * v.y() - w.y() * v.x()) / area, r = (u.x() * w.y() - u.y() * w.x()) / area;
    if (s < 0 || r < 0 || s + r > 1) continue;
    const double z = a.z() + s * (b.z() - a.z()) + r * (c.z() - a.z());
    top = std::isnan(top) ? z : std::max(top, z);
  }
  return top;
}

class ClearRunTest : public ::testing::Test {
 protected:
  ClearRunTest() {
    Tile left(0);
    left.AddDeck(40, 28, 10, 3);
    folder_.Write("scene/tiles/left.obj", left.AsObj());
    folder_.Write("scene/tiles/right.obj", Tile(kCell).AsObj());
    folder_.Write("scene/scene.json",
                  R"({"crs": "", "origin": [0, 0, 0], "cell_size": 60, "cols": 2, "rows": 1, "tiles": [
                      {"col": 0, "row": 0, "path": "tiles/left.obj"}, {"col": 1, "row": 0, "path": "tiles/right.obj"}]})");
  }

  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  Json Run(const std::string& out, const std::string& polygons, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", folder_ / "scene", "--out", folder_ / out, "--water", polygons};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = Tilemend(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ReportOf(folder_ / out);
  }
  std::string Pond(const std::string& properties) {
    return folder_.Write("water.geojson", FeatureOf(PondOutline(), properties));
  }
  TriMesh MeshOf(const std::string& path) {
    const auto file = ReadMeshFile(folder_ / path);
    EXPECT_TRUE(file.ok()) << file.status();
    return file.ok() ? file->mesh : TriMesh();
  }
  // Triangles of a tile of the scene that the output lacks, by their corners.
  std::vector<SpaceTriangle> Lost(const std::string& out, const std::string& name) {
    // What the fill lays may have the corners of a triangle that is gone.
    const auto originals = [&](const std::string& path) {
      TriMesh mesh = MeshOf(path);
      const std::string bytes = FilesBelow(folder_.path()).at(path);
      const std::string faces = bytes.substr(0, bytes.find("g tilemend_filled"));
      const std::ptrdiff_t count = std::count(faces.begin(), faces.end(), 'f');
      mesh.triangles.resize(static_cast<size_t>(count));
      return mesh;
    };
    const auto keys = [](const TriMesh& mesh) {
      std::multiset<std::array<std::array<double, 3>, 3>> all;
      for (const Triangle& t : mesh.triangles) {
        std::array<std::array<double, 3>, 3> key;
        for (int k = 0; k < 3; ++k) key[k] = {mesh.points[t[k]].x(), mesh.points[t[k]].y(), mesh.points[t[k]].z()};
        all.insert(key);
      }
      return all;
    };
    auto left = keys(originals(absl::StrCat(out, "/tiles/", name)));
    std::vector<SpaceTriangle> lost;
    for (const auto& key : keys(MeshOf(absl::StrCat("scene/tiles/", name)))) {
      if (const auto found = left.find(key); found != left.end()) {
        left.erase(found);
        continue;
      }
      SpaceTriangle t;
      for (int k = 0; k < 3; ++k) t[k] = {key[k][0], key[k][1], key[k][2]};
      lost.push_back(t);
    }
    return lost;
  }

  const TemporaryFolder folder_;
};

TEST_F(ClearRunTest, NoisyWaterBecomesLevelAndTheJettyStays) {
  const std::string polygons = Pond(R"({"name": "pond", "clear": true})");
  const Json report = Run("out", polygons);
  ASSERT_EQ(report["water"].size(), 1U);
  const double level = report["water"][0]["level_m"];
  EXPECT_NEAR(level, kLevel, 0.1);
  const PlanePolygon outline = PondOutline();
  int64_t all = 0;
  for (const char* name : {"left.obj", "right.obj"}) {
    const std::vector<SpaceTriangle> lost = Lost("out", name);
    all += std::ssize(lost);
    for (const SpaceTriangle& t : lost) {
      for (const Point3& p : t) EXPECT_LE(p.z(), level + 1.5);
    }
  }
  EXPECT_GT(all, 3000);
  EXPECT_EQ(report["cleared"]["triangles"], all);
  EXPECT_EQ(report["cleared"]["areas"][0]["triangles"], all);
  EXPECT_EQ(report["cleared"]["tiles"].size(), 2U);
  const TriMesh tiles[] = {MeshOf("out/tiles/left.obj"), MeshOf("out/tiles/right.obj")};
  int inside = 0, flat = 0, deck = 0;
  for (double x = 20.25; x < 100; x += 1.5) {
    for (double y = 10.25; y < 50; y += 1.5) {
      if (!Contains(outline, {x, y})) continue;
      const double top = TopAt(tiles[x < kCell ? 0 : 1], {x, y});
      const bool on_deck = x >= 40 && x <= 50 && y >= 28 && y <= 31;
      if (on_deck) {
        EXPECT_EQ(top, kDeck);
      }
      deck += on_deck ? 1 : 0;
      inside += on_deck ? 0 : 1;
      flat += !on_deck && std::abs(top - level) <= 0.02 ? 1 : 0;
    }
  }
  EXPECT_GT(deck, 5);
  EXPECT_GE(flat, 0.97 * inside) << flat << " of " << inside;
  Run("three", polygons, {"--workers", "3"});
  EXPECT_EQ(TilesBelow(folder_ / "three"), TilesBelow(folder_ / "out"));
}

TEST_F(ClearRunTest, AGivenLevelCounts) {
  const Json report = Run("out", Pond(R"({"clear": true, "level_m": 2.5, "clear_height": 0.5})"));
  EXPECT_NEAR(report["water"][0]["level_m"].get<double>(), 2.5, 0.001);
  EXPECT_EQ(report["cleared"]["areas"][0]["top_m"], 3.0);
}

TEST_F(ClearRunTest, ARerunTakesOverWhatOtherPolygonsDoNotChange) {
  const std::string polygons = Pond(R"({"clear": true})");
  const Json first = Run("out", polygons);
  const auto tiles = TilesBelow(folder_ / "out");
  const Json again = Run("out", polygons, {"--overwrite"});
  EXPECT_EQ(again["cleared"], first["cleared"]);
  EXPECT_GT(again["tasks"]["taken_over"], 0);
  EXPECT_EQ(TilesBelow(folder_ / "out"), tiles);
  const Json lower = Run("out", Pond(R"({"clear": true, "clear_height": 0.1})"), {"--overwrite"});
  EXPECT_LT(lower["cleared"]["triangles"], first["cleared"]["triangles"]);
  Run("fresh", folder_ / "water.geojson");
  EXPECT_EQ(TilesBelow(folder_ / "out"), TilesBelow(folder_ / "fresh"));
}

TEST_F(ClearRunTest, WhatStandsOnGroundGoesWhateverItsHeight) {
  PlanePolygon around{{{{3, 3}, {9, 3}, {9, 9}, {3, 9}}}};
  Tile tile(0);
  tile.AddDeck(4, 4, 3, 3);
  folder_.Write("scene/tiles/left.obj", tile.AsObj());
  const std::string polygons = folder_.Write("ground.geojson", FeatureOf(around, R"({"water": false})"));
  const Json report = Run("out", "off", {"--clear", polygons});
  EXPECT_EQ(report["water"].size(), 0U);
  EXPECT_EQ(report["cleared"]["triangles"], 2 * 36 + 2 * 9);
  const TriMesh left = MeshOf("out/tiles/left.obj");
  for (double x = 3.5; x < 9; x += 1) EXPECT_NEAR(TopAt(left, {x, 5.25}), kGround, 0.05) << x;
}

TEST_F(ClearRunTest, WhereAllSurfaceIsTakenOutNothingIsFilled) {
  const PlanePolygon all{{{{-50, -50}, {200, -50}, {200, 100}, {-50, 100}}}};
  const std::string polygons = folder_.Write("all.geojson", FeatureOf(all, R"({"water": false, "clear": true})"));
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", polygons});
  EXPECT_EQ(ended.code, 100) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  EXPECT_THAT(report["left"].dump(), HasSubstr("nothing tells its height"));
  EXPECT_GT(report["cleared"]["triangles"], 0);
}

TEST_F(ClearRunTest, APolygonOverNoSurfaceIsAWarning) {
  PlanePolygon beyond{{{{-12, 3}, {0, 3}, {-2, 9}}}};
  const std::string polygons = folder_.Write("water.geojson", FeatureOf(beyond, R"({"name": "pond", "clear": true})"));
  const Json report = Run("out", polygons);
  EXPECT_EQ(report["cleared"]["triangles"], 0);
  EXPECT_THAT(report["warnings"].dump(),
              HasSubstr("(pond): nothing was taken out: it has no level, because no triangle"));
  EXPECT_EQ(FilesBelow(folder_ / "out")["tiles/left.obj"], FilesBelow(folder_ / "scene")["tiles/left.obj"]);
}

TEST_F(ClearRunTest, BadPropertiesAreRefusedWithTheFeature) {
  for (const char* height : {"-1", "\"high\"", "true", "1e9"}) {
    const std::string polygons = Pond(absl::StrCat(R"({"clear": true, "clear_height": )", height, "}"));
    const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", polygons});
    EXPECT_EQ(ended.code, 4) << height;
    EXPECT_THAT(ended.err, HasSubstr("feature 0: property clear_height: ")) << height;
    EXPECT_THAT(ended.err, HasSubstr("expected a number of metres from 0 to 1000"));
  }
  const Ended ended =
      Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", Pond(R"({"clear": "perhaps"})")});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("property clear: 'perhaps': expected true or false"));
}

TEST_F(ClearRunTest, InspectAndFillKnowIt) {
  const std::string polygons = Pond(R"({"clear": true})");
  const Ended inspected = Tilemend({"inspect", folder_ / "scene", "--water", polygons});
  EXPECT_EQ(inspected.code, 0) << inspected.err;
  EXPECT_THAT(inspected.out, HasSubstr("lake"));
  const Ended filled = Tilemend(
      {"fill", folder_ / "scene/tiles/right.obj", "--out", folder_ / "right.obj", "--clear",
       folder_.Write("ground.geojson", FeatureOf({{{{105, 20}, {110, 20}, {110, 30}}}}, R"({"water": false})"))});
  EXPECT_EQ(filled.code, 0) << filled.err;
}

}  // namespace
}  // namespace tilemend
