#include "worker/propose/square_outline.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace tilemend {
namespace {

using Corner = std::pair<int32_t, int32_t>;  // col, row

// Directions along sides: east, north, west, south.
constexpr std::array<Corner, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

// A side with a square of the set on its left, from a corner.
struct Side {
  Corner from;
  int32_t direction;
  auto operator<=>(const Side&) const = default;
};

Corner Ahead(const Corner& corner, int32_t direction) {
  return {corner.first + kSteps[direction].first, corner.second + kSteps[direction].second};
}

class Tracer {
 public:
  explicit Tracer(const SquareSet& set) {
    for (int32_t row = set.row; row < set.row + set.rows; ++row) {
      for (int32_t col = set.col; col < set.col + set.cols; ++col) {
        if (!set.Has(col, row)) continue;
        if (!set.Has(col, row - 1)) open_[{{col, row}, 0}] = true;
        if (!set.Has(col + 1, row)) open_[{{col + 1, row}, 1}] = true;
        if (!set.Has(col, row + 1)) open_[{{col + 1, row + 1}, 2}] = true;
        if (!set.Has(col - 1, row)) open_[{{col, row + 1}, 3}] = true;
      }
    }
  }

  // The sides of one ring, in order; none when all are taken.
  std::vector<Side> Next() {
    std::vector<Side> ring;
    if (open_.empty()) return ring;
    Side side = open_.begin()->first;
    while (open_.erase(side) > 0) {
      ring.push_back(side);
      side = After(side);
    }
    return ring;
  }

 private:
  // Where four sides meet, the one that turns left: squares that touch at a corner are apart.
  Side After(const Side& side) const {
    const Corner corner = Ahead(side.from, side.direction);
    for (const int32_t turn : {1, 0, 3}) {
      const Side next{corner, (side.direction + turn) % 4};
      if (open_.contains(next)) return next;
    }
    return side;  // the ring is closed: taken already
  }

  std::map<Side, bool> open_;
};

}  // namespace

PlanePolygon OutlineOf(const SquareSet& set, double square) {
  PlanePolygon outline;
  Tracer tracer(set);
  for (std::vector<Side> sides = tracer.Next(); !sides.empty(); sides = tracer.Next()) {
    std::vector<Point2>& ring = outline.rings.emplace_back();
    for (size_t i = 0; i < sides.size(); ++i) {
      const Side& side = sides[i];
      const int32_t before = sides[(i + sides.size() - 1) % sides.size()].direction;
      const int32_t after = sides[(i + 1) % sides.size()].direction;
      if (before == side.direction && after == side.direction) continue;  // on a straight line
      const Point2 from(side.from.first, side.from.second);
      const Point2 step(kSteps[side.direction].first, kSteps[side.direction].second);
      ring.emplace_back(square * (from + 0.5 * step));
    }
  }
  return outline;
}

}  // namespace tilemend
