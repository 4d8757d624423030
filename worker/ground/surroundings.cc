#include "worker/ground/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tilemend {

Surroundings::Surroundings(const GroundRaster& lowest)
    : lowest_(lowest),
      reach_(static_cast<int32_t>(std::ceil(kSurroundingsReach / lowest.square)) + 1),
      is_rim_(lowest.heights.size(), false),
      is_near_(lowest.heights.size(), false) {}

bool Surroundings::IsBesideHole(int32_t col, int32_t row) const {
  constexpr int32_t kWithin = 2;  // squares: the triangles of a ragged rim may cover the next one
  for (int32_t r = row - kWithin; r <= row + kWithin; ++r) {
    for (int32_t c = col - kWithin; c <= col + kWithin; ++c) {
      if (lowest_.Contains(c, r) && std::isnan(lowest_.heights[lowest_.IndexOf(c, r)])) return true;
    }
  }
  return false;
}

void Surroundings::AddRim(int32_t col, int32_t row) {
  if (is_rim_[lowest_.IndexOf(col, row)] || !IsBesideHole(col, row)) return;
  is_rim_[lowest_.IndexOf(col, row)] = true;
  for (int32_t r = std::max(row - reach_, lowest_.row); r <= row + reach_; ++r) {
    for (int32_t c = std::max(col - reach_, lowest_.col); c <= col + reach_; ++c) {
      const bool is_within = (c - col) * (c - col) + (r - row) * (r - row) <= reach_ * reach_;
      if (is_within && lowest_.Contains(c, r)) is_near_[lowest_.IndexOf(c, r)] = true;
    }
  }
}

std::vector<GroundSquare> Surroundings::GroundIn(const FilteredGround& filtered) const {
  std::map<std::pair<int32_t, int32_t>, float> lowest;  // by row and column
  ForEach([&](int32_t col, int32_t row) {
    if (!filtered.IsGround(col, row)) return;
    const float height = lowest_.heights[lowest_.IndexOf(col, row)];
    const std::pair wide(SquareAt(row, kSquaresAlongSide), SquareAt(col, kSquaresAlongSide));
    const auto [square, fresh] = lowest.try_emplace(wide, height);
    if (!fresh) square->second = std::min(square->second, height);
  });
  std::vector<GroundSquare> squares;
  for (const auto& [wide, height] : lowest) squares.push_back({wide.second, wide.first, height});
  return squares;
}

}  // namespace tilemend
