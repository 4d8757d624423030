#include "coordinator/check/sample_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tilemend {
namespace {

// Two holes of one cluster that share the seam vertices 70 and 71, between rim vertices at a height of 5.
CellHoles Asked() {
  CellHoles asked;
  for (int i = 0; i < 4; ++i) {
    RimVertex v;
    v.index = i;
    v.position = Point3(i % 2 * 10.0, i / 2 * 10.0, 5);
    asked.vertices.push_back(v);
  }
  for (int i = 0; i < 2; ++i) {
    RimVertex v;
    v.seam_vertex = 70 + i;
    v.position = Point3(5, 3 + 3 * i, 0);
    v.height_known = false;
    asked.vertices.push_back(v);
  }
  asked.holes = {{0, true, {{0, 4, false}, {4, 5, true}, {5, 0, false}}},
                 {1, true, {{1, 5, false}, {5, 4, true}, {4, 1, false}}}};
  return asked;
}

struct Columns {
  std::vector<int32_t> vertex{70, 71};
  std::vector<double> height{5, 6}, laplacian{0, 0.1}, slope_x{0, 0}, slope_y{0, 0};
  bool Ok() const { return CheckClusterSamples(Asked(), false, {vertex, height, laplacian, slope_x, slope_y}).ok(); }
};

TEST(ClusterSampleCheckTest, TakesOneForEachVertexOrNone) {
  EXPECT_TRUE(Columns().Ok());
  EXPECT_TRUE((Columns{{}, {}, {}, {}, {}}.Ok()));
  EXPECT_FALSE((Columns{{70}, {5}, {0}, {0}, {0}}.Ok()));
  EXPECT_FALSE((Columns{{70, 70}}.Ok()));
  EXPECT_FALSE((Columns{{70, 72}}.Ok()));
  EXPECT_FALSE((Columns{{70, -1}}.Ok()));
  EXPECT_FALSE((Columns{{70, 71}, {5}}.Ok()));
}

// Each rim vertex has a number, one stands on an object.
CellHoles AskedWithObject() {
  CellHoles asked = Asked();
  for (int i = 0; i < 4; ++i) asked.vertices[i].seam_vertex = 10 + i;
  asked.vertices[2].on_object = true;
  return asked;
}

bool IsTaken(const CellHoles& asked, bool has_walls, const std::vector<int32_t>& vertices) {
  const std::vector<double> heights(vertices.size(), 5.0), zeros(vertices.size(), 0.0);
  return CheckClusterSamples(asked, has_walls, {vertices, heights, zeros, zeros, zeros}).ok();
}

TEST(ClusterSampleCheckTest, TakesSamplesUnderObjectsAndAtEndsOfSeams) {
  CellHoles asked = AskedWithObject();
  EXPECT_TRUE(IsTaken(asked, false, {70, 71, 12}));
  EXPECT_FALSE(IsTaken(asked, false, {70, 71}));
  EXPECT_FALSE(IsTaken(asked, false, {70, 71, 12, 10}));
  asked.holes[0].segments.push_back({1, 4, true});
  EXPECT_FALSE(IsTaken(asked, false, {70, 71, 12}));
  EXPECT_TRUE(IsTaken(asked, false, {70, 71, 11, 12}));
}

TEST(ClusterSampleCheckTest, TakesSamplesOfTheWholeRimForGroundWithWalls) {
  CellHoles asked = AskedWithObject();
  EXPECT_TRUE(IsTaken(asked, true, {70, 71, 10, 11, 12, 13}));
  EXPECT_FALSE(IsTaken(asked, true, {70, 71, 10, 11, 12}));
  EXPECT_FALSE(IsTaken(asked, true, {70, 71, 10, 11, 12, 13, 13}));
  EXPECT_FALSE(IsTaken(asked, true, {}));
  asked.vertices[2].on_object = false;
  EXPECT_FALSE(IsTaken(asked, true, {70, 71, 10, 11, 12, 13})) << "without an object there are no walls";
}

TEST(ClusterSampleCheckTest, NewVerticesWithoutASegmentMayHaveNone) {
  CellHoles asked = Asked();
  asked.vertices.push_back(asked.vertices.back());
  asked.vertices.back().seam_vertex = 72;
  EXPECT_TRUE(IsTaken(asked, false, {70, 71}));
  EXPECT_TRUE(IsTaken(asked, false, {70, 71, 72}));
  EXPECT_FALSE(IsTaken(asked, false, {70, 71, 72, 72}));
  EXPECT_FALSE(IsTaken(asked, false, {70, 72}));
}

TEST(ClusterSampleCheckTest, RefusesHeightsFarFromTheRimAndNoNumbers) {
  for (const double wrong : {1e9, -1e9, std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE((Columns{{70, 71}, {5, wrong}}.Ok()));
  }
  EXPECT_FALSE((Columns{{70, 71}, {5, 6}, {0, std::nan("")}}.Ok()));
  EXPECT_FALSE((Columns{{70, 71}, {5, 6}, {0, 0}, {HUGE_VAL, 0}}.Ok()));
  EXPECT_FALSE((Columns{{70, 71}, {5, 6}, {0, 0}, {0, 0}, {0, HUGE_VAL}}.Ok()));
}

TEST(LayerSampleCheckTest, TakesOneOfEachHoleThatSharesAVertex) {
  const auto ok = [](const std::vector<int32_t>& vertices, double height = 5) {
    return CheckLayerSamples(Asked(), vertices, std::vector<double>(vertices.size(), height)).ok();
  };
  EXPECT_TRUE(ok({70, 71, 70, 71}));
  EXPECT_FALSE(ok({70, 71}));
  EXPECT_FALSE(ok({70, 71, 70, 71, 71}));
  EXPECT_FALSE(ok({70, 71, 70, 72}));
  EXPECT_FALSE(ok({70, 71, 70, 71}, 1e9));
  EXPECT_FALSE(ok({70, 71, 70, 71}, std::nan("")));
  EXPECT_FALSE(CheckLayerSamples(Asked(), std::vector<int32_t>{70}, {}).ok());
}

}  // namespace
}  // namespace tilemend
