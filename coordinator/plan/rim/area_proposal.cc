#include "coordinator/plan/rim/area_proposal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr double kSquaresPerCell = 128;
constexpr double kMostSquares = 32e6;
constexpr double kMouth = 0.25;         // of a cell: half of the widest mouth that is closed
constexpr int32_t kInside = 2;          // squares between the surface's outline and the area's
constexpr double kFarInside = 2;        // times what is left out along cells that are filled
constexpr double kStraightCorners = 1;  // squares: how far corners may be off the line between others to be left out

// Squares of the plane that are in or out, with a margin that is out.
struct Mask {
  Point2 lo{0, 0};
  double step = 1;
  int32_t columns = 0, rows = 0;
  std::vector<uint8_t> in;

  bool at(int32_t c, int32_t r) const {
    return c >= 0 && r >= 0 && c < columns && r < rows && in[static_cast<size_t>(r) * columns + c] != 0;
  }
};

Mask EmptyMask(const Grid& grid, const std::map<CellId, StoredRecord>& records) {
  CellId last{0, 0};
  for (const auto& [cell, record] : records) last = {std::max(last.col, cell.col), std::max(last.row, cell.row)};
  const Point2 size = grid.cell_size.cwiseProduct(Point2(last.col + 1, last.row + 1));
  Mask mask;
  mask.step = std::max(grid.cell_size.minCoeff() / kSquaresPerCell, std::sqrt(size.prod() / kMostSquares));
  const double margin = grid.cell_size.maxCoeff() * (kMouth + 0.25);
  mask.lo = grid.corner - Point2::Constant(margin);
  mask.columns = static_cast<int32_t>(std::ceil((size.x() + 2 * margin) / mask.step));
  mask.rows = static_cast<int32_t>(std::ceil((size.y() + 2 * margin) / mask.step));
  mask.in.assign(static_cast<size_t>(mask.columns) * mask.rows, 0);
  return mask;
}

// Adds the squares whose middle the surface of a tile covers: where its boundary winds around.
void AddSurface(const SurveyRecord& record, Mask& mask) {
  std::map<int32_t, std::vector<std::pair<double, int>>> crossings;  // by row: where, and +1 for an edge that goes up
  for (const BoundaryEdge& edge : record.edges) {
    const Point2 a = (record.vertices[edge.from].position.head<2>() - mask.lo) / mask.step;
    const Point2 b = (record.vertices[edge.to].position.head<2>() - mask.lo) / mask.step;
    const auto from = static_cast<int32_t>(std::ceil(std::min(a.y(), b.y()) - 0.5));
    for (int32_t row = std::max(from, 0); row < mask.rows && row + 0.5 < std::max(a.y(), b.y()); ++row) {
      const double x = a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      crossings[row].emplace_back(x, a.y() < b.y() ? 1 : -1);
    }
  }
  for (auto& [row, at] : crossings) {
    std::sort(at.begin(), at.end());
    int winding = 0;
    for (size_t i = 0; i + 1 < at.size(); ++i) {
      winding += at[i].second;
      if (winding == 0) continue;
      const auto from = std::max(0, static_cast<int32_t>(std::ceil(at[i].first - 0.5)));
      for (int32_t c = from; c < mask.columns && c + 0.5 < at[i + 1].first; ++c) {
        mask.in[static_cast<size_t>(row) * mask.columns + c] = 1;
      }
    }
  }
}

// Grows what is `value` by `reach` squares in every direction, along one row or column after the other.
void Grow(uint8_t value, int32_t reach, Mask& mask) {
  const auto grow_line = [&](size_t first, size_t stride, int32_t count) {
    std::vector<int32_t> nearest(count, reach + 1);  // squares to the nearest of that value
    for (int32_t i = 0, far = reach + 1; i < count; ++i) {
      far = mask.in[first + i * stride] == value ? 0 : far + 1;
      nearest[i] = far;
    }
    for (int32_t i = count - 1, far = reach + 1; i >= 0; --i) {
      far = mask.in[first + i * stride] == value ? 0 : far + 1;
      nearest[i] = std::min(nearest[i], far);
    }
    for (int32_t i = 0; i < count; ++i) {
      if (nearest[i] <= reach) mask.in[first + i * stride] = value;
    }
  };
  for (int32_t r = 0; r < mask.rows; ++r) grow_line(static_cast<size_t>(r) * mask.columns, 1, mask.columns);
  for (int32_t c = 0; c < mask.columns; ++c) grow_line(c, mask.columns, mask.rows);
}

// Puts in what is out but not connected to the outside.
void FillHoles(Mask& mask) {
  std::vector<uint8_t> outside(mask.in.size(), 0);
  std::vector<std::pair<int32_t, int32_t>> next = {{0, 0}};  // in the margin
  outside[0] = 1;
  while (!next.empty()) {
    const auto [c, r] = next.back();
    next.pop_back();
    for (const auto& [dc, dr] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int32_t to_c = c + dc, to_r = r + dr;
      if (to_c < 0 || to_r < 0 || to_c >= mask.columns || to_r >= mask.rows || mask.at(to_c, to_r)) continue;
      uint8_t& seen = outside[static_cast<size_t>(to_r) * mask.columns + to_c];
      if (std::exchange(seen, 1) == 0) next.emplace_back(to_c, to_r);
    }
  }
  for (size_t i = 0; i < outside.size(); ++i) mask.in[i] = outside[i] == 0;
}

using Corner = std::pair<int32_t, int32_t>;

// The sides of squares between in and out, from corner to corner, what is in on the left.
std::map<Corner, std::vector<Corner>> SidesOf(const Mask& mask) {
  std::map<Corner, std::vector<Corner>> sides;
  for (int32_t r = 0; r < mask.rows; ++r) {
    for (int32_t c = 0; c < mask.columns; ++c) {
      if (!mask.at(c, r)) continue;
      if (!mask.at(c, r - 1)) sides[{c, r}].emplace_back(c + 1, r);
      if (!mask.at(c + 1, r)) sides[{c + 1, r}].emplace_back(c + 1, r + 1);
      if (!mask.at(c, r + 1)) sides[{c + 1, r + 1}].emplace_back(c, r + 1);
      if (!mask.at(c - 1, r)) sides[{c, r + 1}].emplace_back(c, r);
    }
  }
  return sides;
}

// Marks the corners between `from` and `to` that are needed (Douglas and Peucker 1973).
void MarkCorners(const std::vector<Point2>& line, size_t from, size_t to, std::vector<bool>& needed) {
  std::vector<std::pair<size_t, size_t>> stretches = {{from, to}};
  while (!stretches.empty()) {
    const auto [a, b] = stretches.back();
    stretches.pop_back();
    size_t farthest = a;
    double most = kStraightCorners;
    for (size_t i = a + 1; i < b; ++i) {
      const Point2 way = line[b] - line[a], off = line[i] - line[a];
      const double along = way.squaredNorm() > 0 ? std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
      if (const double distance = (off - along * way).norm(); distance > most) {
        most = distance;
        farthest = i;
      }
    }
    if (farthest == a) continue;
    needed[farthest] = true;
    stretches.emplace_back(a, farthest);
    stretches.emplace_back(farthest, b);
  }
}

// A ring of corners with the needed ones alone, in metres.
std::vector<Point2> Simplified(std::vector<Point2> line, const Mask& mask) {
  const size_t count = line.size();
  line.push_back(line.front());
  std::vector<bool> needed(count + 1, false);
  needed[0] = needed[count / 2] = true;
  MarkCorners(line, 0, count / 2, needed);
  MarkCorners(line, count / 2, count, needed);
  std::vector<Point2> ring;
  for (size_t i = 0; i < count; ++i) {
    if (needed[i]) ring.emplace_back(mask.lo + mask.step * line[i]);
  }
  return ring;
}

std::vector<std::vector<Point2>> RingsOf(const Mask& mask) {
  std::vector<std::vector<Point2>> rings;
  for (auto sides = SidesOf(mask); !sides.empty();) {
    std::vector<Point2> line;
    const Corner first = sides.begin()->first;
    Corner at = first;
    do {
      line.emplace_back(at.first, at.second);
      const auto side = sides.find(at);
      at = side->second.back();
      side->second.pop_back();
      if (side->second.empty()) sides.erase(side);
    } while (at != first);
    if (auto ring = Simplified(std::move(line), mask); ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return rings;
}

// Rings have what is inside on their left.
double DirectedArea(const PlanePolygon& polygon) {
  double twice = 0;
  for (const std::vector<Point2>& ring : polygon.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
      twice += a.x() * b.y() - b.x() * a.y();
    }
  }
  return twice / 2;
}

}  // namespace

PlanePolygon ProposeArea(const Grid& grid, const std::map<CellId, StoredRecord>& records) {
  Mask mask = EmptyMask(grid, records);
  for (const auto& [cell, record] : records) {
    if (record != nullptr) AddSurface(*record.Outline(), mask);
  }
  const auto mouth = static_cast<int32_t>(kMouth * grid.cell_size.minCoeff() / mask.step);
  Grow(1, mouth, mask);
  FillHoles(mask);
  Grow(0, mouth + kInside, mask);
  return {RingsOf(mask)};
}

PlanePolygon OutlineInsideCells(const Grid& grid, const std::map<CellId, StoredRecord>& records) {
  const PlanePolygon outline = ProposeArea(grid, records);
  double missing = -DirectedArea(outline), perimeter = 0;
  for (const auto& [cell, record] : records) {
    missing += grid.cell_size.prod();
    const CellId beside[] = {
        {cell.col - 1, cell.row}, {cell.col + 1, cell.row}, {cell.col, cell.row - 1}, {cell.col, cell.row + 1}};
    for (int side = 0; side < 4; ++side)
      perimeter += records.contains(beside[side]) ? 0 : grid.cell_size[side < 2 ? 1 : 0];
  }
  const double regular = perimeter * kInside * grid.cell_size.minCoeff() / kSquaresPerCell;
  return missing > kFarInside * regular ? outline : PlanePolygon();
}

}  // namespace tilemend
