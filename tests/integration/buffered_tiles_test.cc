// Tiles that were cut from one raster with a buffer: neighbours have the same surface along their border.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "common/mesh/rounding.h"
#include "tests/support/fill_pipeline.h"
#include "tests/support/height_over.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

constexpr int kSquares = 20;  // along a cell's side
constexpr int kBuffer = 3;

double Hills(double x, double y) { return 3 * std::sin(x / 17) + 2 * std::cos(y / 11); }

// Two cells by two, with a pond over the corner of all, one between two cells that ends at the grid line along straight
// shores, and one inside the buffers alone.
bool IsThere(int32_t x, int32_t y) {
  const bool corner = std::hypot(x + 0.5 - 21, y + 0.5 - 19) < 7;
  const bool straight = x >= 4 && x < 12 && y >= 15 && y < 20;
  const bool small = x >= 30 && x < 33 && y >= 18 && y < 22;
  return !corner && !straight && !small;
}

SurveyedScene BufferedScene() {
  std::map<CellId, TriMesh> tiles;
  for (const int32_t col : {0, 1}) {
    for (const int32_t row : {0, 1}) {
      const auto lo = [](int32_t k) { return std::max(0, k * kSquares - kBuffer); };
      const auto hi = [](int32_t k) { return std::min(2 * kSquares, (k + 1) * kSquares + kBuffer); };
      tiles[{col, row}] = Moved(SquaresMesh(lo(col), hi(col), lo(row), hi(row), IsThere), [](const Point3& p) {
        return RoundedTo(NumberType::kFloat32, Point3(p.x(), p.y(), Hills(p.x(), p.y())));
      });
    }
  }
  Grid grid;
  grid.cell_size = Point2(kSquares, kSquares);
  return SurveyScene(grid, std::move(tiles));
}

class BufferedTilesTest : public testing::Test {
 protected:
  BufferedTilesTest() : scene_(BufferedScene()), filled_(FillScene(scene_, {})) {}

  std::optional<double> Fill(CellId cell, const Point2& p) const {
    return HeightOver(filled_.tiles.at(cell), scene_.tiles.at(cell).triangles.size(), p);
  }

  const SurveyedScene scene_;
  const FilledScene filled_;
};

TEST_F(BufferedTilesTest, FillsCoverTheHolesAndNothingElse) {
  for (const auto& [hole, patch] : filled_.patches) EXPECT_EQ(patch.failure, "");
  for (int32_t x = 1; x < 2 * kSquares - 1; ++x) {
    for (int32_t y = 1; y < 2 * kSquares - 1; ++y) {
      bool is_filled = false;
      for (const auto& [cell, tile] : scene_.tiles) is_filled = is_filled || Fill(cell, {x + 0.4, y + 0.7}).has_value();
      EXPECT_EQ(is_filled, !IsThere(x, y)) << x << ", " << y;
    }
  }
}

// Not to a hair: across the corner each tile has triangles of its own.
TEST_F(BufferedTilesTest, FillsOfNeighboursMeet) {
  int places = 0;
  double furthest = 0;
  for (double x = kSquares - kBuffer + 0.1; x < kSquares + kBuffer; x += 0.25) {
    for (double y = 8.1; y < 30; y += 0.25) {
      std::optional<double> first;
      for (const auto& [cell, tile] : scene_.tiles) {
        const std::optional<double> height = Fill(cell, {x, y});
        if (!height) continue;
        if (first) furthest = std::max(furthest, std::abs(*height - *first));
        places += first.has_value();
        first = first.value_or(*height);
      }
    }
  }
  EXPECT_GT(places, 500);
  EXPECT_LT(furthest, 0.05);
}

}  // namespace
}  // namespace tilemend
