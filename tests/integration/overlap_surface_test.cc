// One surface in the strip that two tiles fill, with the surface of Wang 2021.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/support/fill_pipeline.h"
#include "tests/support/height_over.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

constexpr int kSquares = 24;  // along a cell's side

double Hills(double x, double y) {
  return 0.6 * std::sin(0.31 * x) + 0.5 * std::cos(0.27 * y) + 0.04 * std::sin(5 * x + 3 * y);
}

// A lake over two cells: columns 6 to 41 of 48, rows 5 to 18 of 24.
std::vector<std::string> Lake() {
  const std::string shore(kSquares, '#'), bank(6, '#'), open(kSquares - 6, '.');
  std::vector<std::string> picture(kSquares, absl::StrCat(bank, open, "|", open, bank));
  for (int row = 0; row < kSquares; ++row) {
    if (row < 5 || row > 18) picture[row] = absl::StrCat(shore, "|", shore);
  }
  return picture;
}

class OverlapSurfaceTest : public testing::TestWithParam<std::tuple<double, SeamPoints, Closure>> {
 protected:
  OverlapSurfaceTest()
      : margin_(std::get<0>(GetParam())), scene_(OverlappingScene(Lake(), kSquares, margin_, 1, Hills)) {
    PipelineOptions options;
    options.fill.surface = Surface::kWang;
    options.plan.seam_points = std::get<1>(GetParam());
    options.fill.wang.closure = std::get<2>(GetParam());
    filled_ = FillScene(scene_, options);
  }

  std::optional<double> Fill(CellId cell, const Point2& p) const {
    return HeightOver(filled_.tiles.at(cell), scene_.tiles.at(cell).triangles.size(), p);
  }

  const double margin_;
  const SurveyedScene scene_;
  FilledScene filled_;
};

TEST_P(OverlapSurfaceTest, BothTilesHaveOne) {
  for (const auto& [hole, patch] : filled_.patches) EXPECT_EQ(patch.failure, "");
  double furthest = 0;
  int places = 0;
  for (double x = kSquares - margin_ + 0.01; x < kSquares + margin_; x += margin_ / 4) {
    for (double y = 5 + 1.1; y < 19 - 1.1; y += 0.13) {
      const auto west = Fill({0, 0}, {x, y}), east = Fill({1, 0}, {x, y});
      ASSERT_TRUE(west && east) << x << ", " << y;
      furthest = std::max(furthest, std::abs(*west - *east));
      ++places;
    }
  }
  EXPECT_GT(places, 500);
  EXPECT_LT(furthest, 0.002);
}

INSTANTIATE_TEST_SUITE_P(MarginsAndClosures, OverlapSurfaceTest,
                         testing::Combine(testing::Values(0.1, 0.4, 1.5),
                                          testing::Values(SeamPoints::kProjected, SeamPoints::kSpaced),
                                          testing::Values(Closure::kBuffers, Closure::kLine)));

}  // namespace
}  // namespace tilemend
