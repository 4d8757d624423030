#include "worker/propose/square_set.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tilemend {
namespace {

constexpr std::array<std::pair<int32_t, int32_t>, 4> kSides = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

// The squares beside each other, from `first`, that are neither of the set nor seen. `closed` is false if they reach
// the edge of the raster.
std::vector<int32_t> PatchFrom(const SquareSet& set, int32_t first, std::vector<bool>& seen, bool& closed) {
  std::vector<int32_t> patch = {first};
  seen[first] = true;
  closed = true;
  for (size_t i = 0; i < patch.size(); ++i) {
    const int32_t col = patch[i] % set.cols, row = patch[i] / set.cols;
    closed = closed && col > 0 && row > 0 && col + 1 < set.cols && row + 1 < set.rows;
    for (const auto& [dc, dr] : kSides) {
      const int32_t c = col + dc, r = row + dr;
      if (c < 0 || r < 0 || c >= set.cols || r >= set.rows) continue;
      const int32_t other = r * set.cols + c;
      if (set.has[other] || seen[other]) continue;
      seen[other] = true;
      patch.push_back(other);
    }
  }
  return patch;
}

}  // namespace

SquareSet SetOf(const std::vector<Square>& squares) {
  SquareSet set;
  if (squares.empty()) return set;
  Square lo = squares.front(), hi = lo;
  for (const Square& s : squares) {
    lo = {std::min(lo.col, s.col), std::min(lo.row, s.row)};
    hi = {std::max(hi.col, s.col), std::max(hi.row, s.row)};
  }
  set = {lo.col - 1, lo.row - 1, hi.col - lo.col + 3, hi.row - lo.row + 3, {}};
  set.has.resize(static_cast<size_t>(set.cols) * set.rows);
  for (const Square& s : squares) set.has[static_cast<size_t>(s.row - set.row) * set.cols + (s.col - set.col)] = true;
  return set;
}

int64_t CountOf(const SquareSet& set) { return std::count(set.has.begin(), set.has.end(), true); }

SquareSet WithSmallIslands(const SquareSet& set, int64_t most) {
  SquareSet filled = set;
  std::vector<bool> seen(set.has.size(), false);
  for (int32_t i = 0; i < static_cast<int32_t>(set.has.size()); ++i) {
    if (set.has[i] || seen[i]) continue;
    bool closed = false;
    const std::vector<int32_t> patch = PatchFrom(set, i, seen, closed);
    if (!closed || static_cast<int64_t>(patch.size()) > most) continue;
    for (const int32_t square : patch) filled.has[square] = true;
  }
  return filled;
}

std::vector<Square> RimOf(const SquareSet& set) {
  std::vector<Square> rim;
  for (int32_t row = set.row; row < set.row + set.rows; ++row) {
    for (int32_t col = set.col; col < set.col + set.cols; ++col) {
      if (set.Has(col, row)) continue;
      bool touches = false;
      for (int32_t r = row - 1; r <= row + 1; ++r) {
        for (int32_t c = col - 1; c <= col + 1; ++c) touches = touches || set.Has(c, r);
      }
      if (touches) rim.push_back({col, row});
    }
  }
  return rim;
}

}  // namespace tilemend
