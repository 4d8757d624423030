#include "common/mesh/triangulation/insertion_order.h"

#include <algorithm>
#include <bit>

namespace tilemend::internal {
namespace {

constexpr int kHilbertBits = 29;  // a cell per step of a window of 2^29 steps; 2 * 29 bits leave 6 for the round

// Distance along the Hilbert curve of a square of 2^kHilbertBits.
uint64_t HilbertKey(uint32_t x, uint32_t y) {
  uint64_t key = 0;
  for (uint32_t s = 1u << (kHilbertBits - 1); s > 0; s >>= 1) {
    const uint32_t right = (x & s) != 0, up = (y & s) != 0;
    key = key << 2 | ((3 * right) ^ up);
    if (up == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

uint64_t Hash(uint64_t x) {  // the finalizer of splitmix64
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Sorts `indices` by round_of(place in the list), which is below 64, then along a Hilbert curve.
template <typename RoundOf>
void SortAlongCurve(std::span<const Point32> points, const RoundOf& round_of, std::vector<int32_t>& indices) {
  if (indices.empty()) return;
  Point32 lo = points[indices[0]], hi = lo;
  for (int32_t i : indices) {
    lo = {std::min(lo.x, points[i].x), std::min(lo.y, points[i].y)};
    hi = {std::max(hi.x, points[i].x), std::max(hi.y, points[i].y)};
  }
  // Relative to the box, so that moving all points leaves the order as it is.
  const uint64_t side = static_cast<uint64_t>(std::max(int64_t{hi.x} - lo.x, int64_t{hi.y} - lo.y));
  const int shift = std::max(0, static_cast<int>(std::bit_width(side)) - kHilbertBits);
  std::vector<std::pair<uint64_t, int32_t>> keyed;
  keyed.reserve(indices.size());
  for (size_t i = 0; i < indices.size(); ++i) {
    const Point32 p = points[indices[i]];
    const uint32_t x = static_cast<uint32_t>((int64_t{p.x} - lo.x) >> shift);
    const uint32_t y = static_cast<uint32_t>((int64_t{p.y} - lo.y) >> shift);
    keyed.emplace_back(round_of(i) << (2 * kHilbertBits) | HilbertKey(x, y), indices[i]);
  }
  std::sort(keyed.begin(), keyed.end());
  for (size_t i = 0; i < indices.size(); ++i) indices[i] = keyed[i].second;
}

}  // namespace

void SortForInsertion(std::span<const Point32> points, std::vector<int32_t>& indices) {
  const int rounds = static_cast<int>(std::bit_width(indices.size()));
  const auto round_of = [rounds](size_t i) {
    const int level = std::min(rounds, std::countr_zero(Hash(i) | 1ull << 62));
    return static_cast<uint64_t>(rounds - level);
  };
  SortAlongCurve(points, round_of, indices);
}

void SortAlongCurve(std::span<const Point32> points, std::vector<int32_t>& indices) {
  SortAlongCurve(
      points, [](size_t) { return uint64_t{0}; }, indices);
}

}  // namespace tilemend::internal
