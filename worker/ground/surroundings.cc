#include "worker/ground/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tilemend {

bool IsBesideHole(const GroundRaster& lowest, int32_t col, int32_t row) {
  constexpr int32_t kWithin = 2;
  for (int32_t r = row - kWithin; r <= row + kWithin; ++r) {
    for (int32_t c = col - kWithin; c <= col + kWithin; ++c) {
      if (lowest.Contains(c, r) && std::isnan(lowest.heights[lowest.IndexOf(c, r)])) return true;
    }
  }
  return false;
}

SquareBlocks SurroundingsOf(const SquareBlocks& rims, double square) {
  return rims.GrownBy(static_cast<int32_t>(std::ceil(kSurroundingsReach / square)) + 1);
}

std::vector<GroundSquare> GroundIn(const SquareBlocks& near, const GroundRaster& lowest,
                                   const FilteredGround& filtered) {
  std::map<std::pair<int32_t, int32_t>, float> heights;  // by row and column
  near.ForRuns([&](int32_t raster_row, int32_t first, int32_t end) {
    const int32_t row = lowest.row + raster_row;
    for (int32_t col = lowest.col + first; col < lowest.col + end; ++col) {
      if (!filtered.IsGround(col, row)) continue;
      const float height = lowest.heights[lowest.IndexOf(col, row)];
      const std::pair wide(SquareAt(row, kSquaresAlongSide), SquareAt(col, kSquaresAlongSide));
      const auto [square, fresh] = heights.try_emplace(wide, height);
      if (!fresh) square->second = std::min(square->second, height);
    }
  });
  std::vector<GroundSquare> squares;
  for (const auto& [wide, height] : heights) squares.push_back({wide.second, wide.first, height});
  return squares;
}

}  // namespace tilemend
