#include "coordinator/check/survey_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>

#include "tests/support/mesh_builders.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

constexpr int64_t kMost = 100'000;

// A slope of 5 x 5 squares with a hole in the middle.
SurveyRecord Honest() {
  const auto keep = [](int32_t i, int32_t j) { return i != 2 || j != 2; };
  return SurveyTile(SquaresMesh(0, 5, 0, 5, keep, [](double x, double y) { return 0.25 * x + 0.125 * y; }), true);
}

bool Takes(const std::function<void(SurveyRecord&)>& change) {
  SurveyRecord record = Honest();
  change(record);
  return CheckSurvey(record, kMost).ok();
}

TEST(SurveyCheckTest, TakesWhatASurveyGives) {
  EXPECT_TRUE(CheckSurvey(Honest(), kMost).ok());
  TriMesh empty;
  EXPECT_TRUE(CheckSurvey(SurveyTile(empty, true), kMost).ok());
}

TEST(SurveyCheckTest, CountsFitEachOtherAndTheFile) {
  EXPECT_FALSE(CheckSurvey(Honest(), 10).ok());
  for (int64_t SurveyRecord::*count :
       {&SurveyRecord::vertex_count, &SurveyRecord::triangle_count, &SurveyRecord::doubled_vertices,
        &SurveyRecord::degenerate_triangles, &SurveyRecord::nonmanifold_edges}) {
    EXPECT_FALSE(Takes([&](SurveyRecord& r) { r.*count = -1; }));
    EXPECT_FALSE(Takes([&](SurveyRecord& r) { r.*count = std::numeric_limits<int32_t>::max(); }));
  }
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.vertex_count = 3; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.triangle_count = 0; }));
}

// Draco takes less than a byte for a triangle, and nodes of a glTF file may share one mesh.
TEST(SurveyCheckTest, OnlyFilesWithoutCompressionBoundTheCounts) {
  EXPECT_EQ(MostOf("tiles/a.ply", 10), 10);
  EXPECT_EQ(MostOf("tiles/a.obj", 10), 10);
  for (const char* tree : {"tiles/a.json", "tiles/a.osgb"}) {
    EXPECT_TRUE(CheckSurvey(Honest(), MostOf(tree, 10)).ok()) << tree;
    EXPECT_EQ(MostOf(tree, 10), std::numeric_limits<int32_t>::max() / 2) << tree;
  }
  EXPECT_EQ(MostOf("tiles/a.ply", int64_t{1} << 40), std::numeric_limits<int32_t>::max() / 2);
}

TEST(SurveyCheckTest, VerticesLieInTheTile) {
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.lo.x() = std::nan(""); }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { std::swap(r.lo, r.hi); }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.hi = r.lo; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.vertices[0].centroid_height = 1e9; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.vertices[0].normal = {0, 0, 2}; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.edges[0].piece = 5; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.vertices[0].index = r.vertices[1].index; }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.band.points.back().x() = 1e9; }));
  const auto beyond = [](double metres) {  // in a tile with a vertex far outside its cell
    return [metres](SurveyRecord& r) {
      r.hi.x() = 1e7;
      r.band.points.back().y() = r.hi.y() + metres;
    };
  };
  EXPECT_TRUE(Takes(beyond(0.05)));
  EXPECT_FALSE(Takes(beyond(0.15)));
}

TEST(SurveyCheckTest, EdgesAreThoseOfTheBand) {
  for (size_t i = 0; i < Honest().edges.size(); ++i) {
    EXPECT_FALSE(Takes([&](SurveyRecord& r) { r.edges.erase(r.edges.begin() + static_cast<int64_t>(i)); }));
    EXPECT_FALSE(Takes([&](SurveyRecord& r) { std::swap(r.edges[i].from, r.edges[i].to); }));
    EXPECT_FALSE(Takes([&](SurveyRecord& r) { r.edges.push_back(r.edges[i]); }));
  }
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.edges.clear(); }));
  EXPECT_FALSE(Takes([](SurveyRecord& r) { r.band.triangles.clear(); }));
}

TEST(SurveyCheckTest, EdgesMayBeDoubleWhereTrianglesAre) {
  SurveyRecord record = SurveyTile(PiecesOfOneSurface(), true, PieceAreas::kNo);
  ASSERT_EQ(record.edges.size(), 28u);
  EXPECT_TRUE(CheckSurvey(record, kMost).ok()) << CheckSurvey(record, kMost);
  for (size_t e = 0; e < record.edges.size(); ++e) {
    SurveyRecord thrice = record;
    thrice.edges.push_back(record.edges[e]);
    EXPECT_FALSE(CheckSurvey(thrice, kMost).ok()) << e;
    SurveyRecord less = record;
    less.edges.erase(less.edges.begin() + static_cast<ptrdiff_t>(e));
    EXPECT_FALSE(CheckSurvey(less, kMost).ok()) << e;
  }
}

TEST(SurveyCheckTest, ABoundaryHasNoEnd) {
  SurveyRecord record = Honest();
  // One triangle of the band with its boundary edge and that vertex's other edge, gone without a trace in the band.
  const BoundaryEdge gone = record.edges.back();
  record.edges.pop_back();
  std::erase_if(record.band.triangles, [&](const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      if (t[k] == gone.from && t[(k + 1) % 3] == gone.to) return true;
    }
    return false;
  });
  EXPECT_FALSE(CheckSurvey(record, kMost).ok());
}

// A change of one corner of one edge or band triangle never passes.
TEST(SurveyCheckTest, NoSmallChangeOfTheBoundaryPasses) {
  std::mt19937 random(1);
  for (int round = 0; round < 5000; ++round) {
    SurveyRecord record = Honest();
    const auto n = static_cast<uint32_t>(record.vertices.size());
    BoundaryEdge& edge = record.edges[random() % record.edges.size()];
    const BoundaryEdge before = edge;
    (random() % 2 == 0 ? edge.from : edge.to) = static_cast<int32_t>(random() % n);
    const bool same = edge.from == before.from && edge.to == before.to;
    ASSERT_EQ(CheckSurvey(record, kMost).ok(), same);
  }
}

}  // namespace
}  // namespace tilemend
